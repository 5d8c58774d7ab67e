#include "scene/toml_view.h"

#include "scene/frame_scene.h"
#include "scene/obj_numbers.h"
#include "scene/toml_values.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace raysteps {

namespace {

constexpr TomlRange any_coordinate{-greatest_coordinate, greatest_coordinate};
constexpr TomlRange any_light_coordinate{-greatest_light_coordinate, greatest_light_coordinate};
constexpr TomlRange any_color{0.0, 1'000'000.0};
constexpr TomlRange any_angle{0.0, 180.0};
constexpr TomlRange any_length{0.0, greatest_coordinate};
constexpr TomlRange any_sample_count{0.0, 4096.0};

// The sine of the smallest angle between up and the line of sight. The direction to the right is
// their cross product; in floats it is off by about 2^-22 over this sine, 2.4e-4, which is less
// than the angle of a pixel: 40 degrees over 512 pixels are 1.4e-3.
constexpr double smallest_sine = 1e-3;

const toml::node& required(const toml::table& table, std::string_view key, const char* sentence) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        throw toml_error(table.source(), sentence);
    }
    return *node;
}

void check_camera(const Camera& camera, const toml::table& table) {
    const glm::dvec3 line_of_sight = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    if (line_of_sight == glm::dvec3(0.0)) {
        throw toml_error(table.source(),
                         "camera: eye and target are the same point. Move one of them.");
    }
    const toml::node* up_node = table.get("up");
    const toml::source_region& up_source = up_node != nullptr ? up_node->source() : table.source();
    const glm::dvec3 up(camera.up);
    if (up == glm::dvec3(0.0)) {
        throw toml_error(up_source, "camera: up must not be [0, 0, 0].");
    }
    const glm::dvec3 right = glm::cross(glm::normalize(line_of_sight), glm::normalize(up));
    if (glm::length(right) < smallest_sine) {
        throw toml_error(up_source,
                         "camera: up is parallel to the line from eye to target. Turn up.");
    }
}

glm::vec3 edge_of(const toml::table& light, std::string_view key) {
    const toml::node* edge = light.get(key);
    return edge == nullptr ? glm::vec3(0.0f) : toml_vec3(*edge, key, any_coordinate);
}

int whole_number(const toml::node& node, std::string_view key, TomlRange range) {
    const double number = toml_number(node, key, range);
    if (number != std::floor(number)) {
        throw toml_error(node.source(), std::string(key) + " must be a whole number.");
    }
    return static_cast<int>(number);
}

Light light_of(const toml::node& node) {
    const toml::table& table = toml_table(node, "light");
    check_toml_keys(table, "light", {"position", "color", "across", "along"});
    Light light;
    light.position = toml_vec3(required(table, "position", "a light needs a position."), "position",
                               any_light_coordinate);
    if (const toml::node* color = table.get("color")) {
        light.color = toml_color(*color, "color");
    }
    light.across = edge_of(table, "across");
    light.along = edge_of(table, "along");
    if (has_area(light) &&
        glm::cross(glm::dvec3(light.across), glm::dvec3(light.along)) == glm::dvec3(0.0)) {
        throw toml_error(table.source(), "a light with an area needs across and along, which must "
                                         "not be parallel.");
    }
    return light;
}

} // namespace

glm::vec3 toml_color(const toml::node& color, std::string_view key) {
    return toml_vec3(color, key, any_color);
}

Camera toml_camera(const toml::node& node) {
    const toml::table& table = toml_table(node, "camera");
    check_toml_keys(
        table, "camera",
        {"eye", "target", "up", "vertical_field_of_view", "aperture", "focus_distance", "samples"});
    Camera camera;
    camera.eye = toml_vec3(required(table, "eye", "camera needs an eye."), "eye", any_coordinate);
    camera.target =
        toml_vec3(required(table, "target", "camera needs a target."), "target", any_coordinate);
    if (const toml::node* up = table.get("up")) {
        camera.up = toml_vec3(*up, "up", any_coordinate);
    }
    if (const toml::node* angle = table.get("vertical_field_of_view")) {
        const char* key = "vertical_field_of_view";
        camera.vertical_field_of_view = static_cast<float>(toml_number(*angle, key, any_angle));
        if (camera.vertical_field_of_view <= 0.0f || camera.vertical_field_of_view >= 180.0f) {
            throw toml_error(angle->source(),
                             "vertical_field_of_view is an angle in degrees, over 0 "
                             "and under 180.");
        }
    }
    if (const toml::node* aperture = table.get("aperture")) {
        camera.aperture = static_cast<float>(toml_number(*aperture, "aperture", any_length));
    }
    if (const toml::node* distance = table.get("focus_distance")) {
        camera.focus_distance =
            static_cast<float>(toml_number(*distance, "focus_distance", any_length));
    }
    if (const toml::node* samples = table.get("samples")) {
        camera.samples = whole_number(*samples, "samples", any_sample_count);
    }
    check_camera(camera, table);
    return camera;
}

Sky toml_sky(const toml::node& node) {
    const toml::table& table = toml_table(node, "sky");
    check_toml_keys(table, "sky", {"zenith", "horizon", "ground"});
    const auto color = [&](std::string_view key, const char* sentence) {
        return toml_color(required(table, key, sentence), key);
    };
    return {color("zenith", "sky needs the color of the zenith."),
            color("horizon", "sky needs the color of the horizon."),
            color("ground", "sky needs the color of the ground.")};
}

std::vector<Light> toml_lights(const toml::node& node) {
    std::vector<Light> lights;
    for (const toml::node& light : toml_array(node, "light")) {
        lights.push_back(light_of(light));
    }
    return lights;
}

} // namespace raysteps
