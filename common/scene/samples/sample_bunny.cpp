#include "basics/box.h"
#include "basics/error.h"
#include "scene/append_model.h"
#include "scene/mesh.h"
#include "scene/obj/load_obj.h"
#include "scene/samples/samples.h"
#include "scene/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <filesystem>
#include <system_error>
#include <utility>

namespace raysteps {

Scene sample_bunny() {
    const std::filesystem::path path = "/usr/share/glmark2/models/bunny.obj";
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        throw InputError("bunny: " + path.string() +
                         " is not there. Install the package glmark2-data.");
    }
    Scene scene = load_obj(path);
    // Like the other samples it goes by its name, and nothing is said about what its file lacks.
    scene.models.clear();
    scene.runs.clear();
    scene.faces.clear();
    scene.messages.clear();
    return scene;
}

namespace {

constexpr float height = 2.0f;

// On the floor, in the middle.
glm::mat4 placement(const Box& box) {
    const float scale = height / (box.upper.y - box.lower.y);
    const glm::vec3 foot(0.5f * (box.lower.x + box.upper.x), box.lower.y,
                         0.5f * (box.lower.z + box.upper.z));
    return glm::translate(
        glm::scale(glm::translate(glm::mat4(1.0f), {0.0f, 0.01f, 0.0f}), glm::vec3(scale)), -foot);
}

} // namespace

Scene sample_glass_bunny() {
    Scene bunny = sample_bunny();
    for (Material& material : bunny.materials) {
        material = glass("bottle glass", 1.25f, {0.45f, 0.88f, 0.62f});
    }
    Scene scene = append_model({}, bunny, placement(bounds_of(bunny.corners)));
    const int floor = triangle_count(scene);
    scene = add_mesh(std::move(scene), quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}),
                     painted("floor", "made:checker"));
    scene = map_flat(std::move(scene), floor, 4.0f);
    scene.lights = {{{-4.0f, 7.0f, 5.0f}, {0.85f, 0.82f, 0.76f}},
                    {{6.0f, 4.0f, 3.0f}, {0.22f, 0.24f, 0.30f}}};
    scene.camera = {{0.6f, 1.9f, 5.4f}, {0.0f, 0.95f, 0.0f}, {0.0f, 1.0f, 0.0f}, 32.0f};
    scene.camera.samples = 4; // the scan is rough: one ray per pixel shows its noise
    scene.sky = Sky{{0.18f, 0.32f, 0.62f}, {0.72f, 0.78f, 0.82f}, {0.30f, 0.28f, 0.25f}};
    return scene;
}

} // namespace raysteps
