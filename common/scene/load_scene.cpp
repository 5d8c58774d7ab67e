#include "scene/load_scene.h"

#include "basics/error.h"
#include "basics/file.h"
#include "scene/append_model.h"
#include "scene/frame_scene.h"
#include "scene/obj/load_obj.h"
#include "scene/samples/sample_scenes.h"

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace raysteps {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_toml_bytes = 1u << 20;

std::string lower_case(std::string text) {
    for (char& character : text) {
        if (character >= 'A' && character <= 'Z') {
            character = static_cast<char>(character - 'A' + 'a');
        }
    }
    return text;
}

// The same steps as for a model in a scene file, so that to_toml's text gives the same bits.
Scene load_bare_obj(const fs::path& path, float aspect_ratio,
                    const std::optional<Camera>& instead) {
    Scene model = load_obj(path);
    model.models = {{fs::absolute(path).lexically_normal().string(), glm::mat4(1.0f)}};
    Scene scene = append_model({}, model, glm::mat4(1.0f));
    scene.name = model.name;
    return frame_scene(std::move(scene), aspect_ratio, instead);
}

constexpr std::size_t column_width = 22;

std::string line_of(const SampleScene& sample) {
    std::string name(sample.name);
    std::string ranges;
    for (const SampleParameter& parameter : sample.parameters) {
        name += ":" + std::string(parameter.name);
        ranges += "; " + std::string(parameter.name) + " is " + std::to_string(parameter.lowest) +
                  " to " + std::to_string(parameter.highest) + ", else " +
                  std::to_string(parameter.usual);
    }
    name.resize(column_width, ' ');
    return name + std::string(sample.description) + ranges + "\n";
}

} // namespace

Scene load_scene(const std::string& name, float aspect_ratio,
                 const std::optional<Camera>& instead) {
    if (is_sample_name(name)) {
        return make_sample_scene(name, aspect_ratio);
    }
    const fs::path path(name);
    const std::string extension = lower_case(path.extension().string());
    if (extension == ".obj") {
        return load_bare_obj(path, aspect_ratio, instead);
    }
    if (extension == ".toml") {
        return read_toml_scene(read_file(path, most_toml_bytes), path, aspect_ratio, instead);
    }
    std::error_code error;
    if (fs::exists(path, error)) {
        throw InputError(
            name +
            (fs::is_directory(path, error) ? ": this is a folder" : ": this is not a scene file") +
            ". Give a file that ends in .obj or .toml.");
    }
    return make_sample_scene(name, aspect_ratio); // which says that there is no such scene
}

std::string list_scenes() {
    std::string lines;
    for (const SampleScene& sample : sample_scenes()) {
        lines += line_of(sample);
    }
    return lines;
}

} // namespace raysteps
