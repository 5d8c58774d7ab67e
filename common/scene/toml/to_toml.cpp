#include "scene/load_scene.h"

#include "scene/toml/toml_values.h"

#include <glm/mat4x4.hpp>

#include <algorithm>

namespace raysteps {

namespace {

template <class Vector>
std::string vec3_text(const Vector& vector) {
    return "[" + toml_number_text(vector.x) + ", " + toml_number_text(vector.y) + ", " +
           toml_number_text(vector.z) + "]";
}

// A place in the coordinates of the files.
std::string place_text(const Scene& scene, const glm::vec3& place) {
    return scene.origin == glm::dvec3(0.0) ? vec3_text(place)
                                           : vec3_text(glm::dvec3(place) + scene.origin);
}

// Row by row.
std::string matrix_text(const glm::mat4& matrix) {
    std::string text = "[";
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            text += (column == 0 ? "\n  " : " ") + toml_number_text(matrix[column][row]) + ",";
        }
    }
    return text + "\n]";
}

std::string model_text(const Model& model) {
    std::string text = "\n[[model]]\npath = " + toml_string_text(model.path) + "\n";
    if (model.transform != glm::mat4(1.0f)) {
        text += "matrix = " + matrix_text(model.transform) + "\n";
    }
    return text;
}

std::string camera_text(const Scene& scene) {
    const Camera& camera = scene.camera;
    return "\n[camera]\neye = " + place_text(scene, camera.eye) +
           "\ntarget = " + place_text(scene, camera.target) + "\nup = " + vec3_text(camera.up) +
           "\nvertical_field_of_view = " + toml_number_text(camera.vertical_field_of_view) +
           "\naperture = " + toml_number_text(camera.aperture) +
           "\nfocus_distance = " + toml_number_text(camera.focus_distance) +
           "\nsamples = " + std::to_string(camera.samples) + "\n";
}

std::string light_text(const Scene& scene, const Light& light) {
    std::string text = "\n[[light]]\nposition = " + place_text(scene, light.position) +
                       "\ncolor = " + vec3_text(light.color) + "\n";
    if (has_area(light)) {
        text +=
            "across = " + vec3_text(light.across) + "\nalong = " + vec3_text(light.along) + "\n";
    }
    return text;
}

constexpr std::size_t most_runs = 1000;

// A comment ends with its line.
std::string without_control(std::string text) {
    std::replace_if(
        text.begin(), text.end(),
        [](char letter) { return static_cast<unsigned char>(letter) < ' ' || letter == 127; }, '?');
    return text;
}

std::string sky_text(const Sky& sky) {
    return "\n[sky]\nzenith = " + vec3_text(sky.zenith) + "\nhorizon = " + vec3_text(sky.horizon) +
           "\nground = " + vec3_text(sky.ground) + "\n";
}

} // namespace

std::string to_toml(const Scene& scene) {
    const char* key_of_name = scene.models.empty() ? "sample" : "name";
    std::string text = std::string(key_of_name) + " = " + toml_string_text(scene.name) + "\n";
    text += "background = " + vec3_text(scene.background) + "\n";
    if (scene.origin != glm::dvec3(0.0)) {
        text += "origin = " + vec3_text(scene.origin) + "\n";
    }
    if (scene.lights.empty()) {
        text += "light = []\n"; // no light at all; without the key, two would be placed
    }
    if (scene.sky) {
        text += sky_text(*scene.sky);
    }
    text += camera_text(scene);
    for (const Light& light : scene.lights) {
        text += light_text(scene, light);
    }
    for (const Model& model : scene.models) {
        text += model_text(model);
    }
    const std::vector<std::string> runs = describe_runs(scene);
    for (std::size_t i = 0; i < std::min(runs.size(), most_runs); ++i) {
        text += (i == 0 ? "\n# " : "# ") + without_control(runs[i]) + "\n";
    }
    if (runs.size() > most_runs) {
        text += "# and " + std::to_string(runs.size() - most_runs) + " runs more\n";
    }
    return text;
}

} // namespace raysteps
