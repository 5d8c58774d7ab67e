#include "scene/load_scene.h"

#include "basics/error.h"
#include "basics/file.h"
#include "scene/append_model.h"
#include "scene/frame_scene.h"
#include "scene/load_model.h"
#include "scene/pictures.h"
#include "scene/samples/sample_scenes.h"
#include "scene/scaling.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
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
Scene load_bare_model(const fs::path& path, float aspect_ratio, const SceneRequest& request) {
    const double scale = std::ldexp(1.0, request.scale_exponent);
    const glm::mat4 transform = glm::scale(glm::mat4(1.0f), glm::vec3(static_cast<float>(scale)));
    Scene model = find_cutouts(load_model(path, Origin::near_model));
    model.models = {{fs::absolute(path).lexically_normal().string(), transform}};
    Scene scene;
    scene.origin = scale * model.origin;
    scene.name = model.name;
    scene = append_model(std::move(scene), std::move(model), transform);
    for (Material& material : scene.materials) {
        material = scaled(std::move(material), request.scale_exponent);
    }
    scene.background = calm_background;
    scene.camera = place_camera(scene, aspect_ratio, request.camera);
    scene.lights = place_model_lights(scene, aspect_ratio);
    return scene;
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

Scene load_file(const fs::path& path, float aspect_ratio, const SceneRequest& request) {
    Scene scene = is_model_path(path) ? load_bare_model(path, aspect_ratio, request)
                                      : read_toml_scene(read_file(path, most_toml_bytes), path,
                                                        aspect_ratio, request);
    const std::string warning = warn_of_size(scene);
    if (!warning.empty()) {
        scene.messages.push_back(warning);
    }
    append(scene.messages, tell_precision(scene));
    return scene;
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

Scene load_scene(const std::string& name, float aspect_ratio, const SceneRequest& request) {
    const int scale_exponent = request.scale_exponent;
    if (std::abs(scale_exponent) > greatest_scale_exponent) {
        throw InputError("--scale-exponent " + std::to_string(scale_exponent) + ": take one from " +
                         std::to_string(-greatest_scale_exponent) + " to " +
                         std::to_string(greatest_scale_exponent) + ".");
    }
    if (is_sample_name(name)) {
        if (scale_exponent != 0) {
            throw InputError("--scale-exponent is for models from files, and " + name +
                             " is made by code. Leave it out.");
        }
        if (request.camera.choice != CameraChoice::automatic || request.camera.up != UpAxis::y) {
            throw InputError("--camera and --up with a word are for models from files, and " +
                             name +
                             " is made by code with a camera of its own. Give its --camera in "
                             "numbers, or leave them out.");
        }
        return make_sample_scene(name, aspect_ratio);
    }
    const fs::path path(name);
    if (is_model_path(path) || lower_case(path.extension().string()) == ".toml") {
        return load_file(path, aspect_ratio, request);
    }
    std::error_code error;
    if (fs::exists(path, error)) {
        throw InputError(
            name +
            (fs::is_directory(path, error) ? ": this is a folder" : ": this is not a scene file") +
            ". Give a file that ends in " + scene_endings() + ".");
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
