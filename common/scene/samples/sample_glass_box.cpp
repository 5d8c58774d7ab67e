#include "scene/sample_glass_box.h"

#include "scene/mesh.h"
#include "scene/sample_surfaces.h"
#include "scene/shapes.h"

#include <utility>

namespace raysteps {

namespace {

constexpr float lamp_height = 1.99f;

// The left, the right, and what is before, behind, above and below: seen from inside.
Mesh white_walls() {
    Mesh mesh = quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
    mesh = join(std::move(mesh), quad({-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1}));
    return join(std::move(mesh), quad({-1, 0, -1}, {1, 0, -1}, {1, 2, -1}, {-1, 2, -1}));
}

} // namespace

Scene sample_glass_box() {
    Scene scene;
    scene = add_mesh(std::move(scene), white_walls(), matte("white", glm::vec3(0.74f)));
    scene = add_mesh(std::move(scene), quad({-1, 0, 1}, {-1, 0, -1}, {-1, 2, -1}, {-1, 2, 1}),
                     matte("red", {0.55f, 0.07f, 0.06f}));
    scene = add_mesh(std::move(scene), quad({1, 0, -1}, {1, 0, 1}, {1, 2, 1}, {1, 2, -1}),
                     matte("green", {0.09f, 0.42f, 0.10f}));
    scene = add_mesh(std::move(scene),
                     quad({-0.25f, lamp_height, -0.3f}, {0.25f, lamp_height, -0.3f},
                          {0.25f, lamp_height, 0.2f}, {-0.25f, lamp_height, 0.2f}),
                     glowing("lamp", {1.0f, 0.96f, 0.88f}));
    scene = add_mesh(std::move(scene), sphere({-0.42f, 0.4f, -0.42f}, 0.38f, 14),
                     mirror("silver", glm::vec3(0.02f), {0.93f, 0.94f, 0.95f}));
    scene = add_mesh(std::move(scene), sphere({0.42f, 0.38f, 0.2f}, 0.36f, 14),
                     glass("glass", 1.5f, {0.86f, 0.96f, 0.92f}));
    scene.lights = {{{0.0f, lamp_height, -0.05f},
                     {0.85f, 0.81f, 0.74f},
                     {0.5f, 0.0f, 0.0f},
                     {0.0f, 0.0f, 0.5f}},
                    {{0.0f, 1.2f, 3.9f}, glm::vec3(0.16f)}};
    scene.camera = {{0.0f, 1.0f, 4.1f}, {0.0f, 0.98f, 0.0f}, {0.0f, 1.0f, 0.0f}, 38.0f};
    scene.background = glm::vec3(0.02f);
    return scene;
}

} // namespace raysteps
