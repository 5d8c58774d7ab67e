#include "program/options.h"

#include "basics/error.h"
#include "program/figures.h"
#include "program/output.h"
#include "scene/camera_text.h"
#include "scene/load_scene.h"
#include "scene/scaling.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <iostream>
#include <new>

namespace raysteps {

namespace {

using Check = std::function<void()>;
using PathOf = std::function<std::filesystem::path()>;

struct NamedPath {
    std::string option;
    PathOf path;
};

const std::vector<std::pair<std::string, ContextKind>> contexts{{"auto", ContextKind::automatic},
                                                                {"osmesa", ContextKind::osmesa},
                                                                {"egl", ContextKind::egl},
                                                                {"window", ContextKind::window}};

int fail(const std::string& program, ExitCode code, const std::string& sentence) {
    std::cout.flush();
    std::cerr << program << ": " << sentence << "\n";
    return static_cast<int>(code);
}

// A file that is read must not be written: it would be lost.
void check_files(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs) {
    for (const NamedPath& output : outputs) {
        for (const NamedPath& input : inputs) {
            std::error_code ignored;
            if (!output.path().empty() &&
                std::filesystem::equivalent(output.path(), input.path(), ignored)) {
                throw InputError(output.option + " " + output.path().string() +
                                 ": this is the file of " + input.option +
                                 ", which would be lost. Name another.");
            }
        }
    }
    for (auto a = outputs.begin(); a != outputs.end(); ++a) {
        for (auto b = outputs.begin(); b != a; ++b) {
            if (!a->path().empty() && a->path() == b->path()) {
                throw InputError(a->option + " and " + b->option +
                                 " name the same file. Name two.");
            }
        }
    }
}

// What was printed may be a file that someone works on with: it is whole, or that is an error.
void check_output() {
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw InputError("standard output cannot be written to its end. Make room, or direct it "
                         "to another place.");
    }
}

template <class Number>
Number number_in(const std::string& name, const std::string& text, const std::string& meaning,
                 Number lowest, Number highest) {
    const std::optional<Number> number = parse_number<Number>(text);
    if (!number || !(*number >= lowest && *number <= highest)) { // NaN is in no range
        throw InputError(fmt::format("{} {}: {}. Give a number from {} to {}.", name, text, meaning,
                                     lowest, highest));
    }
    return *number;
}

std::size_t find_choice(const std::string& option, const std::string& word,
                        const std::vector<std::string>& choices) {
    const auto known = std::find(choices.begin(), choices.end(), word);
    if (known == choices.end()) {
        throw InputError(no_such_choice(option, word, "choice", {choices.begin(), choices.end()}));
    }
    return static_cast<std::size_t>(known - choices.begin());
}

// "1 light", "2 lights".
std::string count_of(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : separator) + word;
    }
    return text;
}

// Whether --camera has numbers.
bool names_place(const PictureOptions& picture) {
    return !picture.camera.empty() && !camera_choice(picture.camera);
}

CameraRequest camera_request(const PictureOptions& picture) {
    CameraRequest request;
    request.choice = camera_choice(picture.camera).value_or(CameraChoice::automatic);
    request.up = static_cast<UpAxis>(find_choice("--up", picture.up, up_axes()));
    // For a scene that is too large to place a camera in front of it.
    if (names_place(picture)) {
        request.instead = scaled(parse_camera(picture.camera, Camera{}), picture.scale_exponent);
    } else if (!picture.needs_camera) {
        request.instead = Camera{};
    }
    return request;
}

Scene load(const PictureOptions& picture) {
    const int exponent = picture.scale_exponent;
    Scene scene = load_scene(picture.scene, aspect_ratio(picture.size),
                             {.scale_exponent = exponent, .camera = camera_request(picture)});
    if (names_place(picture)) { // in the lengths of the file
        const glm::dvec3 origin = std::ldexp(1.0, -exponent) * scene.origin;
        scene.camera =
            scaled(parse_camera(picture.camera, scaled(scene.camera, -exponent), origin), exponent);
    }
    return scene;
}

} // namespace

struct Options::Parser {
    std::string program;
    CLI::App app;
    std::deque<std::string> texts; // what the command line gives; CLI11 keeps references to them
    std::deque<bool> flags;
    std::vector<Check> checks;
    std::vector<std::pair<const bool*, Check>> answers;
    std::vector<NamedPath> inputs;
    std::vector<NamedPath> outputs;
};

Options::Options(std::string program, const std::string& purpose)
    : parser_(new Parser{std::move(program), CLI::App(purpose), {}, {}, {}, {}, {}, {}}) {
    parser_->app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    question("--version", "print which version this is, and do nothing else",
             [] { std::cout << version_in_words() << "\n"; });
}

Options::~Options() = default;

const std::string& Options::program() const {
    return parser_->program;
}

void Options::value(const std::string& name, const std::string& initial, const std::string& meaning,
                    std::function<void(const std::string&)> take) {
    std::string& text = parser_->texts.emplace_back();
    CLI::Option* const option = parser_->app.add_option(name, text, meaning);
    option->default_str(initial);
    check([option, &text, take = std::move(take)] {
        if (option->count() > 0) {
            take(text);
        }
    });
}

void Options::text(const std::string& name, std::string& value, const std::string& meaning) {
    this->value(name, value, meaning, [&value](const std::string& text) { value = text; });
}

void Options::list(const std::string& name, std::vector<std::string>& values,
                   const std::string& meaning) {
    value(name, join(values, ","), meaning,
          [&values](const std::string& text) { values = split_words(text, ','); });
}

void Options::flag(const std::string& name, bool& value, const std::string& meaning) {
    parser_->app.add_flag(name, value, meaning);
}

void Options::number(const std::string& name, int& value, const std::string& meaning, int lowest,
                     int highest) {
    this->value(name, std::to_string(value), meaning, [=, &value](const std::string& text) {
        value = number_in(name, text, meaning, lowest, highest);
    });
}

void Options::number(const std::string& name, float& value, const std::string& meaning,
                     float lowest, float highest) {
    this->value(name, fmt::format("{}", value), meaning, [=, &value](const std::string& text) {
        value = number_in(name, text, meaning, lowest, highest);
    });
}

void Options::number(const std::string& name, double& value, const std::string& meaning,
                     double lowest, double highest) {
    this->value(name, fmt::format("{}", value), meaning, [=, &value](const std::string& text) {
        value = number_in(name, text, meaning, lowest, highest);
    });
}

void Options::choice(const std::string& name, std::string& value, const std::string& meaning,
                     const std::vector<std::string>& choices) {
    choose(name, value, meaning, choices, [&value, choices](std::size_t i) { value = choices[i]; });
}

void Options::choose(const std::string& name, const std::string& initial,
                     const std::string& meaning, const std::vector<std::string>& choices,
                     std::function<void(std::size_t)> take) {
    value(name, initial, meaning + ": " + join(choices, ", "),
          [=, take = std::move(take)](const std::string& text) {
              take(find_choice(name, text, choices));
          });
}

void Options::input_file(const std::string& name, std::filesystem::path& value,
                         const std::string& meaning) {
    this->value(name, value.string(), meaning, [&value](const std::string& text) { value = text; });
    parser_->inputs.push_back({name, [&value] { return value; }});
}

void Options::input_file(const std::string& name, std::string& value, const std::string& meaning) {
    text(name, value, meaning);
    parser_->inputs.push_back({name, [&value] { return std::filesystem::path(value); }});
}

void Options::output_file(const std::string& name, std::filesystem::path& value,
                          const std::string& meaning) {
    this->value(name, value.string(), meaning, [&value](const std::string& text) { value = text; });
    parser_->outputs.push_back({name, [&value] { return value; }});
}

void Options::output_folder(const std::string& name, std::filesystem::path& value,
                            const std::string& meaning) {
    this->value(name, value.string(), meaning, [name, &value](const std::string& text) {
        if (text.empty()) {
            throw InputError(name + ": the name of the folder is empty. Name one, or leave out " +
                             name + ".");
        }
        value = text;
    });
}

void Options::question(const std::string& name, const std::string& meaning, Check answer) {
    bool& asked = parser_->flags.emplace_back();
    flag(name, asked, meaning);
    parser_->answers.emplace_back(&asked, std::move(answer));
}

void Options::check(Check check) {
    parser_->checks.push_back(std::move(check));
}

void Options::excludes(const std::string& name, const std::vector<std::string>& others) {
    for (const std::string& other : others) {
        parser_->app.get_option(name)->excludes(parser_->app.get_option(other));
    }
}

bool Options::given(const std::string& name) const {
    return parser_->app.count(name) > 0;
}

int Options::run(int argc, char** argv, const std::function<void()>& body) {
    const std::string& program = parser_->program;
    try {
        parser_->app.parse(argc, argv);
    } catch (const CLI::CallForHelp& help) {
        return parser_->app.exit(help);
    } catch (const CLI::ParseError& error) {
        return fail(program, ExitCode::wrong_input,
                    std::string(error.what()) + ". See --help for the options.");
    }
    try {
        for (const Check& check : parser_->checks) {
            check();
        }
        check_files(parser_->inputs, parser_->outputs);
        const auto asked = std::find_if(parser_->answers.begin(), parser_->answers.end(),
                                        [](const auto& answer) { return *answer.first; });
        asked == parser_->answers.end() ? body() : asked->second();
        check_output();
        return static_cast<int>(ExitCode::done);
    } catch (const Error& error) {
        return fail(program, error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(program, ExitCode::machine_lacks,
                    "memory is short. Take a smaller scene or a smaller --size.");
    } catch (const std::exception& error) {
        return fail(program, ExitCode::machine_lacks,
                    std::string("internal error: ") + error.what() +
                        ". This is a bug in Raysteps; please report it.");
    }
}

float aspect_ratio(const PictureSize& size) {
    return static_cast<float>(size.width) / static_cast<float>(size.height);
}

ContextKind parse_context(const std::string& text) {
    std::vector<std::string> names;
    for (const auto& [name, kind] : contexts) {
        names.push_back(name);
    }
    return contexts[find_choice("--context", text, names)].second;
}

void add_context_option(Options& options, ContextKind& context) {
    options.choice<ContextKind>("--context", context, "where OpenGL runs", contexts);
}

void add_picture_options(Options& options, PictureOptions& picture) {
    if (picture.out.empty()) {
        picture.out = std::filesystem::path("out") / options.program();
    }
    options.input_file(
        "--scene", picture.scene,
        "a model (.obj, .ply, .stl, .gltf, .glb, ...), a .toml file, or the name of a scene (see "
        "--list-scenes)");
    options.value("--size", fmt::format("{}x{}", picture.size.width, picture.size.height),
                  "the picture's width and height in pixels, as in 640x480",
                  [&](const std::string& text) { picture.size = parse_size(text); });
    options.text("--camera", picture.camera,
                 "eye x,y,z and target x,y,z, optionally followed by the vertical field of view "
                 "in degrees, and then by up x,y,z; or, for a model from a file, front, left, top, "
                 "inside or file");
    options.choice("--up", picture.up, "the axis of a model from a file that points up", up_axes());
    options.number("--scale-exponent", picture.scale_exponent,
                   "multiply all lengths of the file, of --camera and of --rays by 2 to this "
                   "power, for a model that is too small for floats; hits stay as they are",
                   -greatest_scale_exponent, greatest_scale_exponent);
    options.output_folder("--out", picture.out, "the folder for the pictures");
    options.output_file("--json", picture.json, "a file for the measured numbers");
    add_context_option(options, picture.context);
    options.flag("--window", picture.window, "show the picture in a window; H lists its keys");
    options.question("--list-scenes", "print the names that --scene accepts, and do nothing else",
                     [] { std::cout << list_scenes(); });
    options.question("--print-scene", "print the scene as a TOML file, and do nothing else",
                     [&] { std::cout << to_toml(load(picture)); });
    // A scene file and a camera that C prints in a window have lengths of their own: there, a model
    // is scaled by its `scale` (docs/scene_files.md).
    options.excludes("--scale-exponent", {"--window", "--print-scene"});
}

Scene load_scene(const PictureOptions& picture) {
    const auto loaded = [&] {
        const WorkNotice notice("loading " + picture.scene);
        return load(picture);
    };
    const Scene scene = loaded();
    for (const std::string& message : scene.messages) {
        std::cerr << message << "\n";
    }
    std::cout << "scene     " << scene.name << ", "
              << count_of(scene.corners.size() / 3, "triangle") << ", "
              << count_of(scene.materials.size(), "material") << ", "
              << count_of(scene.lights.size(), "light") << "\n";
    return scene;
}

Scene load_scene(PictureOptions picture, const std::string& scene) {
    picture.scene = scene;
    return load_scene(picture);
}

std::unique_ptr<Context> open_context(const PictureOptions& picture) {
    if (!picture.window) {
        return open_context(picture.context);
    }
    std::unique_ptr<Context> context =
        make_window_context(picture.size.width, picture.size.height, Visibility::shown);
    std::cout << "OpenGL    " << renderer_name() << "\n" << std::flush;
    return context;
}

std::unique_ptr<Context> open_context(ContextKind kind) {
    std::unique_ptr<Context> context = make_context(kind);
    std::cout << "OpenGL    " << renderer_name() << "\n" << std::flush;
    return context;
}

} // namespace raysteps
