#include "basics/text.h"
#include "scene/append_model.h"
#include "scene/frame_scene.h"
#include "scene/load_model.h"
#include "scene/load_scene.h"
#include "scene/obj/obj_file.h"
#include "scene/pictures.h"
#include "scene/samples/sample_scenes.h"
#include "scene/scaling.h"
#include "scene/toml/toml_values.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <system_error>

namespace raysteps {

namespace {

namespace fs = std::filesystem;

constexpr TomlRange any_coordinate{-greatest_coordinate, greatest_coordinate};
constexpr TomlRange any_degrees{-360'000.0, 360'000.0};

glm::dmat3 scaling(const toml::node& node) {
    glm::dvec3 factors{1.0};
    if (node.is_number()) {
        factors = glm::dvec3(toml_number(node, "scale", any_coordinate));
    } else if (node.is_array()) {
        const std::vector<double> numbers = toml_numbers(node, "scale", 3, any_coordinate);
        factors = {numbers[0], numbers[1], numbers[2]};
    } else {
        throw toml_error(node.source(), "scale must be a number or an array of 3 numbers.");
    }
    glm::dmat3 matrix{1.0};
    for (int i = 0; i < 3; ++i) {
        matrix[i][i] = factors[i];
    }
    return matrix;
}

// By the formula of Rodrigues (1840): what points along the axis stays, what is across it turns.
glm::dmat3 rotation(const toml::node& node) {
    const toml::table& table = toml_table(node, "rotate");
    check_toml_keys(table, "rotate", {"axis", "degrees"});
    const toml::node* axis_node = table.get("axis");
    const toml::node* degrees_node = table.get("degrees");
    if (axis_node == nullptr || degrees_node == nullptr) {
        throw toml_error(node.source(),
                         "rotate needs both, as in { axis = [0, 1, 0], degrees = 90 }.");
    }
    const glm::dvec3 given(toml_vec3(*axis_node, "axis", any_coordinate));
    if (given == glm::dvec3(0.0)) {
        throw toml_error(axis_node->source(), "axis must not be [0, 0, 0].");
    }
    const glm::dvec3 axis = glm::normalize(given);
    const double angle = glm::radians(toml_number(*degrees_node, "degrees", any_degrees));
    glm::dmat3 matrix;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 unit{0.0};
        unit[i] = 1.0;
        const glm::dvec3 along = glm::dot(axis, unit) * axis;
        matrix[i] =
            along + std::cos(angle) * (unit - along) + std::sin(angle) * glm::cross(axis, unit);
    }
    return matrix;
}

glm::mat4 whole_matrix(const toml::node& node) {
    const std::vector<double> rows = toml_numbers(node, "matrix", 16, any_coordinate);
    glm::mat4 matrix;
    auto number = rows.begin();
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            matrix[column][row] = static_cast<float>(*number++);
        }
    }
    const glm::vec4 last_row{matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]};
    if (last_row != glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)) {
        throw toml_error(node.source(), "the last row of matrix must be 0, 0, 0, 1.");
    }
    return matrix;
}

// Whether the columns span no volume. Their numbers were rounded to floats, by up to 2^-24 each, so
// columns that lie in one plane can seem to span a share of up to about 6 * 2^-24 < 1e-6 of the
// volume that they would span at right angles.
bool flattens(const glm::mat4& matrix) {
    glm::dmat3 directions;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 column(matrix[i]);
        if (column == glm::dvec3(0.0)) {
            return true;
        }
        directions[i] = glm::normalize(column);
    }
    return std::abs(glm::determinant(directions)) < 1e-6;
}

glm::mat4 composed_matrix(const toml::table& model) {
    glm::dmat3 linear{1.0};
    if (const toml::node* scale = model.get("scale")) {
        linear = scaling(*scale);
    }
    if (const toml::node* rotate = model.get("rotate")) {
        linear = rotation(*rotate) * linear;
    }
    glm::mat4 matrix = glm::mat4(glm::mat3(linear));
    if (const toml::node* translate = model.get("translate")) {
        matrix[3] = glm::vec4(toml_vec3(*translate, "translate", any_coordinate), 1.0f);
    }
    return matrix;
}

// Where a [[model]] stands: its `matrix`, or its `scale`, then `rotate`, then `translate`.
glm::mat4 toml_transform(const toml::table& model) {
    const toml::node* matrix_node = model.get("matrix");
    for (const char* key : {"translate", "rotate", "scale"}) {
        if (matrix_node != nullptr && model.contains(key)) {
            throw toml_error(model.get(key)->source(),
                             std::string(key) + " and matrix exclude each other. Keep one.");
        }
    }
    const glm::mat4 matrix =
        matrix_node != nullptr ? whole_matrix(*matrix_node) : composed_matrix(model);
    if (flattens(matrix)) {
        throw toml_error(model.source(), "this transform flattens the model: no scale may be 0, "
                                         "and no row of a matrix may depend on the others.");
    }
    return matrix;
}

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

glm::vec3 toml_color(const toml::node& color, std::string_view key) {
    return toml_vec3(color, key, any_color);
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

// A place in the coordinates of the files, as seen from the origin.
glm::vec3 place_of(const toml::node& node, std::string_view key, TomlRange range,
                   const glm::dvec3& origin) {
    const std::vector<double> numbers = toml_numbers(node, key, 3, range);
    return as_seen_from(origin, {numbers[0], numbers[1], numbers[2]});
}

Light light_of(const toml::node& node, const glm::dvec3& origin) {
    const toml::table& table = toml_table(node, "light");
    check_toml_keys(table, "light", {"position", "color", "across", "along"});
    Light light;
    light.position = place_of(required(table, "position", "a light needs a position."), "position",
                              any_light_coordinate, origin);
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

Camera toml_camera(const toml::node& node, const glm::dvec3& origin) {
    const toml::table& table = toml_table(node, "camera");
    check_toml_keys(
        table, "camera",
        {"eye", "target", "up", "vertical_field_of_view", "aperture", "focus_distance", "samples"});
    Camera camera;
    camera.eye =
        place_of(required(table, "eye", "camera needs an eye."), "eye", any_coordinate, origin);
    camera.target = place_of(required(table, "target", "camera needs a target."), "target",
                             any_coordinate, origin);
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

std::vector<Light> toml_lights(const toml::node& node, const glm::dvec3& origin,
                               int scale_exponent) {
    std::vector<Light> lights;
    for (const toml::node& light : toml_array(node, "light")) {
        lights.push_back(scaled(light_of(light, origin), scale_exponent));
    }
    return lights;
}

// Triangles are counted in ints, and 2^24 of them take about 2 GB.
constexpr std::size_t most_triangles = 1u << 24;

toml::table parse(std::string_view text, const fs::path& path) {
    try {
        return toml::parse(text, path.string());
    } catch (const toml::parse_error& error) {
        throw toml_error(error.source(), std::string(error.description()) + ".");
    }
}

void check_extent(const Scene& scene, const toml::source_region& source) {
    const Box box = bounds_of(scene.corners);
    for (int axis = 0; axis < 3 && !is_empty(box); ++axis) {
        if (box.lower[axis] < -greatest_coordinate || box.upper[axis] > greatest_coordinate) {
            throw toml_error(source,
                             "this transform moves the model beyond 1.8e18. Scale it down.");
        }
    }
}

Scene load_toml_model(const toml::node& node, const fs::path& folder, int scale_exponent) {
    const toml::table& table = toml_table(node, "model");
    check_toml_keys(table, "model", {"path", "translate", "rotate", "scale", "matrix"});
    const toml::node* path_node = table.get("path");
    if (path_node == nullptr) {
        throw toml_error(table.source(), "a model needs the path of its file.");
    }
    const std::string given = toml_string(*path_node, "path");
    const fs::path path = fs::absolute(folder / given).lexically_normal();
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        throw toml_error(path_node->source(), "there is no file " + in_quotes(given) + " in \"" +
                                                  folder.string() + "\". Correct the path.");
    }
    if (!is_model_path(path)) {
        throw toml_error(path_node->source(), in_quotes(given) +
                                                  " is not a model file, such as one that ends in "
                                                  ".obj, .ply, .stl or .glb. Name one.");
    }
    const glm::vec3 factors(std::ldexp(1.0f, scale_exponent));
    const glm::mat4 transform = glm::scale(glm::mat4(1.0f), factors) * toml_transform(table);
    Scene model = find_cutouts(load_model(path, Origin::near_model));
    model.models = {{path.string(), transform}};
    return model;
}

// The box of the models where their transforms put them.
DoubleBox box_in_world(const std::vector<Scene>& models) {
    DoubleBox box;
    for (const Scene& model : models) {
        const Box own = bounds_of(model.corners);
        const glm::dmat4 transform(model.models.front().transform);
        for (int i = 0; i < 8 && !is_empty(own); ++i) {
            const glm::dvec3 corner((i & 1) == 0 ? own.lower.x : own.upper.x,
                                    (i & 2) == 0 ? own.lower.y : own.upper.y,
                                    (i & 4) == 0 ? own.lower.z : own.upper.z);
            extend(box, glm::dvec3(transform * glm::dvec4(corner + model.origin, 1.0)));
        }
    }
    return box;
}

glm::dvec3 toml_origin(const toml::node& node, int scale_exponent) {
    const std::vector<double> numbers = toml_numbers(node, "origin", 3, any_coordinate);
    return std::ldexp(1.0, scale_exponent) * glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

Scene read_models(const toml::table& file, const fs::path& path, int scale_exponent) {
    const toml::node& models = *file.get("model");
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::vector<Scene> loaded;
    std::vector<toml::source_region> sources;
    std::size_t corners = 0;
    for (const toml::node& model : toml_array(models, "model")) {
        loaded.push_back(load_toml_model(model, folder, scale_exponent));
        sources.push_back(model.source());
        corners += loaded.back().corners.size();
        if (corners > 3 * most_triangles) {
            throw toml_error(model.source(), "with this model the scene has more than 16777216 "
                                             "triangles. Leave some out.");
        }
    }
    if (loaded.empty()) {
        throw toml_error(models.source(), "model must name at least one file.");
    }
    Scene scene;
    scene.name = path.stem().string();
    scene.background = calm_background;
    const toml::node* origin = file.get("origin");
    scene.origin =
        origin != nullptr ? toml_origin(*origin, scale_exponent) : offset_of(box_in_world(loaded));
    for (std::size_t i = 0; i < loaded.size(); ++i) {
        const glm::mat4 transform = loaded[i].models.front().transform;
        scene = append_model(std::move(scene), std::move(loaded[i]), transform);
        check_extent(scene, sources[i]);
    }
    for (Material& material : scene.materials) {
        material = scaled(std::move(material), scale_exponent);
    }
    return scene;
}

Scene read_sample(const toml::node& sample, float aspect_ratio, int scale_exponent) {
    const std::string name = toml_string(sample, "sample");
    if (scale_exponent != 0) {
        throw toml_error(sample.source(), "--scale-exponent is for models from files, and a sample "
                                          "is made by code. Leave it out.");
    }
    try {
        return make_sample_scene(name, aspect_ratio);
    } catch (const InputError& error) {
        throw toml_error(sample.source(), error.what());
    }
}

Scene read_geometry(const toml::table& table, const fs::path& path, float aspect_ratio,
                    int scale_exponent) {
    const toml::node* models = table.get("model");
    const toml::node* sample = table.get("sample");
    const toml::node* name = table.get("name");
    if (models == nullptr && sample == nullptr) {
        throw InputError(path.string() +
                         ": the file names no scene. Add a [[model]] with the path of "
                         "an OBJ file, or a sample.");
    }
    if (models != nullptr && sample != nullptr) {
        throw toml_error(sample->source(), "sample and model exclude each other. Keep one.");
    }
    if (sample != nullptr && name != nullptr) {
        throw toml_error(name->source(), "a sample has its own name. Remove name.");
    }
    if (sample != nullptr && table.contains("origin")) {
        throw toml_error(table.get("origin")->source(), "a sample has its own origin. Remove it.");
    }
    if (sample != nullptr) {
        return read_sample(*sample, aspect_ratio, scale_exponent);
    }
    Scene scene = read_models(table, path, scale_exponent);
    if (name != nullptr) {
        scene.name = toml_string(*name, "name");
    }
    return scene;
}

} // namespace

Scene read_toml_scene(std::string_view text, const fs::path& path, float aspect_ratio,
                      const SceneRequest& request) {
    const int scale_exponent = request.scale_exponent;
    const toml::table table = parse(text, path);
    check_toml_keys(table, "a scene file",
                    {"name", "sample", "model", "origin", "camera", "light", "background", "sky"});
    Scene scene = read_geometry(table, path, aspect_ratio, scale_exponent);
    if (const toml::node* background = table.get("background")) {
        scene.background = toml_color(*background, "background");
    }
    if (const toml::node* sky = table.get("sky")) {
        scene.sky = toml_sky(*sky);
    }
    const glm::dvec3 origin = std::ldexp(1.0, -scale_exponent) * scene.origin;
    if (const toml::node* camera = table.get("camera")) {
        scene.camera = scaled(toml_camera(*camera, origin), scale_exponent);
    } else if (!scene.models.empty()) {
        scene.messages.push_back("No camera in " + path.string() + ": it was placed to show all.");
        scene.camera = place_camera(scene, aspect_ratio, request.camera);
    }
    if (const toml::node* lights = table.get("light")) {
        scene.lights = toml_lights(*lights, origin, scale_exponent);
    } else if (!scene.models.empty()) {
        scene.lights = place_model_lights(scene, aspect_ratio);
        scene.messages.push_back("No light in " + path.string() + ": " +
                                 (has_area(scene.lights.front())
                                      ? "what glows in its models is the light."
                                      : "two were placed."));
    }
    return scene;
}

} // namespace raysteps
