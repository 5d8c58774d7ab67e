#include "program/command.h"

#include "program/parse_options.h"
#include "basics/error.h"
#include "scene/camera_text.h"
#include "basics/text.h"
#include "scene/load_scene.h"

#include <cstdio>
#include <iostream>
#include <new>

namespace raysteps {

namespace {

int exit_code(ExitCode code) {
    return static_cast<int>(code);
}

int fail(const Command& command, ExitCode code, const std::string& sentence) {
    std::cerr << command.chapter << ": " << sentence << "\n";
    return exit_code(code);
}

float aspect_ratio(const Command& command) {
    return static_cast<float>(command.width) / static_cast<float>(command.height);
}

Scene load(const Command& command) {
    Scene scene = load_scene(command.scene, aspect_ratio(command));
    if (!command.camera.empty()) {
        scene.camera = parse_camera(command.camera, scene.camera);
    }
    return scene;
}

// A file that is read must not be written: it would be lost.
void check_outputs(const Command& command) {
    for (const auto& [option, output] :
         {std::pair{"--hits", command.hits}, std::pair{"--json", command.json}}) {
        for (const auto& [input_option, input] :
             {std::pair{"--rays", command.rays},
              std::pair{"--scene", std::filesystem::path(command.scene)}}) {
            std::error_code ignored;
            if (!output.empty() && std::filesystem::equivalent(output, input, ignored)) {
                throw InputError(std::string(option) + " " + output.string() +
                                 ": this is the file of " + input_option +
                                 ", which would be lost. Name another.");
            }
        }
    }
    if (!command.hits.empty() && command.hits == command.json) {
        throw InputError("--hits and --json name the same file. Name two.");
    }
    if (command.out.empty()) {
        throw InputError("--out: the name of the folder is empty. Name one, or leave out --out.");
    }
}

// Answers that need no picture. True where one was given.
bool answer_questions(const Command& command) {
    if (command.list_scenes) {
        std::cout << list_scenes();
    } else if (command.print_scene) {
        std::cout << to_toml(load(command));
    }
    return command.list_scenes || command.print_scene;
}

// What was printed may be a file that someone works on with: it is whole, or that is an error.
void check_output() {
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw InputError("standard output cannot be written to its end. Make room, or direct it "
                         "to another place.");
    }
}

// "1 light", "2 lights".
std::string count_of(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

} // namespace

void add_common_options(CLI::App& app, Command& command) {
    command.out = std::filesystem::path("out") / command.chapter;
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app.add_option("--scene", command.scene,
                   "an .obj or .toml file, or the name of a scene (see --list-scenes)")
        ->capture_default_str();
    app.add_option("--size", command.size, "of the picture in pixels, as in 640x480")
        ->capture_default_str();
    app.add_option(
        "--camera", command.camera,
        "eye x,y,z, target x,y,z, and perhaps the vertical field of view in degrees, and "
        "up x,y,z");
    app.add_option("--out", command.out, "the folder that the pictures go to")
        ->capture_default_str();
    app.add_option("--json", command.json, "a file for the measured numbers");
    app.add_option("--context", command.context, "where OpenGL runs: auto, osmesa, egl or window")
        ->capture_default_str();
    app.add_flag("--window", command.window, "show the picture in a window; H tells its keys");
    app.add_flag("--print-scene", command.print_scene,
                 "print the scene as a TOML file, and do nothing else");
    app.add_flag("--list-scenes", command.list_scenes,
                 "print the names that --scene knows, and do nothing else");
}

int run_command(CLI::App& app, Command& command, int argc, char** argv,
                const std::function<void()>& body) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return fail(command, ExitCode::wrong_input,
                    std::string(error.what()) + ". See --help for the options.");
    }
    try {
        const PictureSize size = parse_size(command.size);
        command.width = size.width;
        command.height = size.height;
        if (command.rays.empty() != command.hits.empty()) {
            throw InputError("--rays and --hits go together: name a file of rays and a file for "
                             "their hits.");
        }
        check_outputs(command);
        if (!answer_questions(command)) {
            body();
        }
        check_output();
        return exit_code(ExitCode::done);
    } catch (const Error& error) {
        std::cout.flush();
        return fail(command, error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(command, ExitCode::machine_lacks,
                    "memory is short. Take a smaller scene or a smaller --size.");
    } catch (const std::exception& error) {
        return fail(command, ExitCode::machine_lacks,
                    std::string("something failed that should not: ") + error.what() +
                        ". This is a fault of Raysteps.");
    }
}

Scene open_scene(const Command& command) {
    Scene scene = load(command);
    for (const std::string& message : scene.messages) {
        std::cerr << message << "\n";
    }
    std::cout << "scene     " << scene.name << ", "
              << count_of(scene.corners.size() / 3, "triangle") << ", "
              << count_of(scene.materials.size(), "material") << ", "
              << count_of(scene.lights.size(), "light") << "\n";
    return scene;
}

std::unique_ptr<Context> open_context(const Command& command) {
    std::unique_ptr<Context> context;
    const ContextKind kind = parse_context(command.context);
    if (command.window) {
        context = make_window_context(command.width, command.height, Visibility::shown);
    } else {
        context = make_context(kind);
    }
    std::cout << "OpenGL    " << renderer_name() << "\n" << std::flush;
    return context;
}

} // namespace raysteps
