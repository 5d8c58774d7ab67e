#pragma once

#include "basics/text.h"
#include "gpu/context.h"
#include "scene/scene.h"

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace raysteps {

// A program's command line. Each option is declared beside the variable that holds its default, and
// sets that variable when the program runs; `--help` lists them in this order.
class Options {
public:
    // The name comes first in each of the program's errors, the purpose first in its help.
    Options(std::string program, const std::string& purpose);
    ~Options();

    const std::string& program() const;

    void text(const std::string& name, std::string& value, const std::string& meaning);

    // Words between commas.
    void list(const std::string& name, std::vector<std::string>& values,
              const std::string& meaning);

    void flag(const std::string& name, bool& value, const std::string& meaning);

    // A number of that range, both ends included.
    void number(const std::string& name, int& value, const std::string& meaning,
                int lowest = std::numeric_limits<int>::lowest(),
                int highest = std::numeric_limits<int>::max());
    void number(const std::string& name, float& value, const std::string& meaning, float lowest,
                float highest);
    void number(const std::string& name, double& value, const std::string& meaning, double lowest,
                double highest);

    // One of a few words. The help lists them behind the meaning.
    void choice(const std::string& name, std::string& value, const std::string& meaning,
                const std::vector<std::string>& choices);

    // The same, where each word stands for a value.
    template <class Value>
    void choice(const std::string& name, Value& value, const std::string& meaning,
                const std::vector<std::pair<std::string, Value>>& choices) {
        std::vector<std::string> words;
        std::string initial;
        for (const auto& [word, meant] : choices) {
            words.push_back(word);
            initial = meant == value ? word : initial;
        }
        choose(name, initial, meaning, words,
               [&value, choices](std::size_t i) { value = choices[i].second; });
    }

    // No file that the program reads may be written as well, and no file twice.
    void input_file(const std::string& name, std::filesystem::path& value,
                    const std::string& meaning);
    void input_file(const std::string& name, std::string& value, const std::string& meaning);
    void output_file(const std::string& name, std::filesystem::path& value,
                     const std::string& meaning);
    void output_folder(const std::string& name, std::filesystem::path& value,
                       const std::string& meaning);

    // An option of its own kind: `take` is called with the text that was given, and throws
    // InputError where it cannot be used.
    void value(const std::string& name, const std::string& initial, const std::string& meaning,
               std::function<void(const std::string&)> take);

    // With this flag the program prints an answer, and does nothing else.
    void question(const std::string& name, const std::string& meaning,
                  std::function<void()> answer);

    // What must hold once all options have their values: throws InputError where it does not.
    void check(std::function<void()> check);

    // The option and those others, which must be declared already, cannot be given together.
    void excludes(const std::string& name, const std::vector<std::string>& others);

    // Whether the command line has the option; known when the program's body runs.
    bool given(const std::string& name) const;

    // Reads the command line and runs the body. An Error, or whatever else goes wrong, becomes one
    // sentence on standard error and the exit code of the program.
    int run(int argc, char** argv, const std::function<void()>& body);

private:
    void choose(const std::string& name, const std::string& initial, const std::string& meaning,
                const std::vector<std::string>& choices, std::function<void(std::size_t)> take);

    struct Parser;
    std::unique_ptr<Parser> parser_;
};

// What the programs of all chapters are asked: which picture of which scene, and where it goes.
struct PictureOptions {
    std::string scene{};
    PictureSize size{512, 512};
    int scale_exponent = 0;      // all lengths of a file are multiplied by 2 to this power
    std::string camera{};        // empty: the scene's own
    std::string up = "y";        // the axis that is up, where a camera is placed
    std::filesystem::path out{}; // empty: the program's folder in out/
    std::filesystem::path json{};
    ContextKind context = ContextKind::automatic;
    bool window = false;
    bool needs_camera = true; // else a scene too large for one will do as well
};

// --scene --size --camera --up --scale-exponent --out --json --context --window --print-scene
// --list-scenes
void add_picture_options(Options& options, PictureOptions& picture);

// auto, osmesa, egl or window. Throws InputError.
ContextKind parse_context(const std::string& text);

// --context by itself.
void add_context_option(Options& options, ContextKind& context);

float aspect_ratio(const PictureSize& size);

// The scene of --scene with the camera of --camera. Prints what it is, and what the loader has to
// say.
Scene load_scene(const PictureOptions& picture);

// The same for another scene than that of --scene.
Scene load_scene(PictureOptions picture, const std::string& scene);

// The context of --context, or a window where --window is given. Prints the renderer's name.
std::unique_ptr<Context> open_context(const PictureOptions& picture);
std::unique_ptr<Context> open_context(ContextKind kind);

} // namespace raysteps
