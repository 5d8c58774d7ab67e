#include "scene/load_scene.h"

#include "scene/toml/toml_values.h"

#include <glm/mat4x4.hpp>

namespace raysteps {

namespace {

std::string vec3_text(const glm::vec3& vector) {
    return "[" + toml_number_text(vector.x) + ", " + toml_number_text(vector.y) + ", " +
           toml_number_text(vector.z) + "]";
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

std::string camera_text(const Camera& camera) {
    return "\n[camera]\neye = " + vec3_text(camera.eye) + "\ntarget = " + vec3_text(camera.target) +
           "\nup = " + vec3_text(camera.up) +
           "\nvertical_field_of_view = " + toml_number_text(camera.vertical_field_of_view) +
           "\naperture = " + toml_number_text(camera.aperture) +
           "\nfocus_distance = " + toml_number_text(camera.focus_distance) +
           "\nsamples = " + std::to_string(camera.samples) + "\n";
}

std::string light_text(const Light& light) {
    std::string text = "\n[[light]]\nposition = " + vec3_text(light.position) +
                       "\ncolor = " + vec3_text(light.color) + "\n";
    if (has_area(light)) {
        text +=
            "across = " + vec3_text(light.across) + "\nalong = " + vec3_text(light.along) + "\n";
    }
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
    if (scene.lights.empty()) {
        text += "light = []\n"; // no light at all; without the key, two would be placed
    }
    if (scene.sky) {
        text += sky_text(*scene.sky);
    }
    text += camera_text(scene.camera);
    for (const Light& light : scene.lights) {
        text += light_text(light);
    }
    for (const Model& model : scene.models) {
        text += model_text(model);
    }
    return text;
}

} // namespace raysteps
