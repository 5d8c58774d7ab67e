#include "scene/toml_scene.h"

#include "scene/append_model.h"
#include "scene/frame_scene.h"
#include "scene/load_obj.h"
#include "scene/obj_findings.h"
#include "scene/obj_numbers.h"
#include "scene/sample_scenes.h"
#include "scene/toml_transform.h"
#include "scene/toml_values.h"
#include "scene/toml_view.h"

#include <cmath>
#include <system_error>

namespace raysteps {

namespace {

namespace fs = std::filesystem;

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

Scene append_toml_model(Scene scene, const toml::node& node, const fs::path& folder) {
    const toml::table& table = toml_table(node, "model");
    check_toml_keys(table, "model", {"path", "translate", "rotate", "scale", "matrix"});
    const toml::node* path_node = table.get("path");
    if (path_node == nullptr) {
        throw toml_error(table.source(), "a model needs the path of an OBJ file.");
    }
    const std::string given = toml_string(*path_node, "path");
    const fs::path path = fs::absolute(folder / given).lexically_normal();
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        throw toml_error(path_node->source(), "there is no file " + in_quotes(given) + " in \"" +
                                                  folder.string() + "\". Correct the path.");
    }
    if (path.extension() != ".obj" && path.extension() != ".OBJ") {
        throw toml_error(path_node->source(),
                         in_quotes(given) + " is no OBJ file. Name a file that ends in .obj.");
    }
    const glm::mat4 transform = toml_transform(table);
    Scene model = load_obj(path);
    model.models = {{path.string(), transform}};
    if (scene.corners.size() + model.corners.size() > 3 * most_triangles) {
        throw toml_error(table.source(), "with this model the scene has more than 16777216 "
                                         "triangles. Leave some out.");
    }
    scene = append_model(std::move(scene), model, transform);
    check_extent(scene, table.source());
    return scene;
}

Scene read_models(const toml::node& models, const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    Scene scene;
    scene.name = path.stem().string();
    scene.background = calm_background;
    for (const toml::node& model : toml_array(models, "model")) {
        scene = append_toml_model(std::move(scene), model, folder);
    }
    if (scene.models.empty()) {
        throw toml_error(models.source(), "model must name at least one OBJ file.");
    }
    return scene;
}

Scene read_sample(const toml::node& sample, float aspect_ratio) {
    const std::string name = toml_string(sample, "sample");
    try {
        return make_sample_scene(name, aspect_ratio);
    } catch (const InputError& error) {
        throw toml_error(sample.source(), error.what());
    }
}

Scene read_geometry(const toml::table& table, const fs::path& path, float aspect_ratio) {
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
    if (sample != nullptr) {
        return read_sample(*sample, aspect_ratio);
    }
    Scene scene = read_models(*models, path);
    if (name != nullptr) {
        scene.name = toml_string(*name, "name");
    }
    return scene;
}

} // namespace

Scene read_toml_scene(std::string_view text, const fs::path& path, float aspect_ratio) {
    const toml::table table = parse(text, path);
    check_toml_keys(table, "a scene file",
                    {"name", "sample", "model", "camera", "light", "background", "sky"});
    Scene scene = read_geometry(table, path, aspect_ratio);
    if (const toml::node* background = table.get("background")) {
        scene.background = toml_color(*background, "background");
    }
    if (const toml::node* sky = table.get("sky")) {
        scene.sky = toml_sky(*sky);
    }
    if (const toml::node* camera = table.get("camera")) {
        scene.camera = toml_camera(*camera);
    } else if (!scene.models.empty()) {
        scene.camera = frame_camera(scene, aspect_ratio);
        scene.messages.push_back("No camera in " + path.string() + ": it was placed to show all.");
    }
    if (const toml::node* lights = table.get("light")) {
        scene.lights = toml_lights(*lights);
    } else if (!scene.models.empty()) {
        scene.lights = find_lights(scene);
        scene.messages.push_back("No light in " + path.string() + ": " +
                                 (has_area(scene.lights.front())
                                      ? "what glows in its models is the light."
                                      : "two were placed."));
    }
    return scene;
}

} // namespace raysteps
