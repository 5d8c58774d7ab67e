#include "scene/sample_soft_light.h"

#include "scene/mesh.h"
#include "scene/sample_surfaces.h"
#include "scene/shapes.h"

#include <utility>

namespace raysteps {

Scene sample_soft_light() {
    Scene scene;
    scene = add_mesh(std::move(scene), quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}),
                     matte("floor", {0.70f, 0.67f, 0.62f}));
    scene = add_mesh(std::move(scene), box({-2.3f, 0.01f, -1.1f}, {-1.5f, 3.0f, -0.3f}),
                     matte("pillar", {0.66f, 0.42f, 0.22f}));
    scene = add_mesh(std::move(scene), sphere({0.1f, 0.81f, 0.2f}, 0.8f, 12),
                     matte("ball", {0.20f, 0.42f, 0.62f}));
    scene = add_mesh(std::move(scene), icosahedron({1.9f, 0.55f, -0.4f}, 0.6f),
                     matte("gem", {0.60f, 0.16f, 0.14f}));
    scene = add_mesh(std::move(scene), box({0.9f, 0.01f, 1.2f}, {1.7f, 0.35f, 2.0f}),
                     matte("slab", {0.28f, 0.50f, 0.26f}));
    scene.lights = {
        {{-4.0f, 5.5f, 2.5f}, {0.95f, 0.91f, 0.84f}, {1.6f, 0.0f, 1.6f}, {0.9f, 1.2f, -0.9f}},
        {{7.0f, 4.0f, 6.0f}, glm::vec3(0.14f)}};
    scene.camera = {{0.9f, 3.6f, 8.0f}, {-0.1f, 1.05f, 0.0f}, {0.0f, 1.0f, 0.0f}, 40.0f};
    scene.background = {0.30f, 0.34f, 0.40f};
    return scene;
}

} // namespace raysteps
