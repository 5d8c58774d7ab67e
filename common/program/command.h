#pragma once

#include "gpu/context.h"
#include "scene/scene.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace raysteps {

// What a person asks of a chapter's program, with the options that all chapters share.
struct Command {
    std::string chapter{}; // 02_triangles
    std::string scene{};
    std::string size = "512x512";
    std::string camera{};
    std::string context = "auto";
    std::string triangle = "watertight";
    std::string structure = "every_triangle";
    std::map<std::string, std::string> build_values{}; // what the structure's builder is told
    std::filesystem::path out{};
    std::filesystem::path json{};
    std::filesystem::path rays{};
    std::filesystem::path hits{};
    bool window = false;
    bool print_scene = false;
    bool list_scenes = false;

    // Of `size`, once the command line has been read.
    int width = 512;
    int height = 512;
};

// --scene --size --out --context --window --camera --json --print-scene --list-scenes
void add_common_options(CLI::App& app, Command& command);

// Reads the command line and runs the body. An Error, or whatever else goes wrong, becomes one
// sentence on standard error and the exit code of the program.
int run_command(CLI::App& app, Command& command, int argc, char** argv,
                const std::function<void()>& body);

// The scene of --scene with the camera of --camera. Prints what the loader has to say.
Scene open_scene(const Command& command);

// The context of --context, or a window where --window is given. Prints the renderer's name.
std::unique_ptr<Context> open_context(const Command& command);

} // namespace raysteps
