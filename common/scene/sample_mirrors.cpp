#include "scene/sample_mirrors.h"

#include "scene/mesh.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"

#include <utility>

namespace raysteps {

namespace {

constexpr int tiles_along = 8;

// The tiles whose column and row add up to this remainder by two.
Mesh tiles(int remainder) {
    Mesh mesh;
    for (int row = 0; row < tiles_along; ++row) {
        for (int column = 0; column < tiles_along; ++column) {
            if ((row + column) % 2 != remainder) {
                continue;
            }
            const float left = static_cast<float>(column - tiles_along / 2);
            const float back = static_cast<float>(row - tiles_along / 2);
            mesh = join(std::move(mesh),
                        quad({left, 0.0f, back + 1.0f}, {left + 1.0f, 0.0f, back + 1.0f},
                             {left + 1.0f, 0.0f, back}, {left, 0.0f, back}));
        }
    }
    return mesh;
}

} // namespace

Scene sample_mirrors() {
    const Material silver = mirror("silver", glm::vec3(0.03f), {0.88f, 0.89f, 0.90f});
    const Material gold = mirror("gold", {0.10f, 0.07f, 0.02f}, {0.90f, 0.68f, 0.30f});
    const Material copper = mirror("copper", {0.08f, 0.04f, 0.03f}, {0.85f, 0.50f, 0.40f});

    Scene scene;
    scene = add_mesh(std::move(scene), tiles(0), matte("light tile", {0.80f, 0.78f, 0.72f}));
    scene = add_mesh(std::move(scene), tiles(1), matte("dark tile", {0.14f, 0.15f, 0.18f}));
    scene = add_mesh(std::move(scene), sphere({-0.9f, 1.11f, -0.6f}, 1.1f, 6), silver);
    scene = add_mesh(std::move(scene), sphere({1.35f, 0.76f, -0.1f}, 0.75f, 4), gold);
    scene = add_mesh(std::move(scene), sphere({0.25f, 0.41f, 1.35f}, 0.4f, 3), copper);
    scene = add_mesh(std::move(scene), box({-3.2f, 0.01f, -3.4f}, {3.2f, 3.2f, -3.2f}), silver);
    scene = add_mesh(std::move(scene), icosahedron({-1.6f, 0.5f, 1.5f}, 0.5f),
                     matte("blue", {0.10f, 0.25f, 0.75f}));
    scene = add_mesh(std::move(scene), box({2.3f, 0.01f, -1.9f}, {3.1f, 1.6f, -1.1f}),
                     matte("green", {0.15f, 0.55f, 0.20f}));
    scene = add_mesh(std::move(scene), box({1.2f, 0.01f, 1.3f}, {1.8f, 0.61f, 1.9f}),
                     matte("red", {0.75f, 0.12f, 0.10f}));
    scene.lights = {{{-4.0f, 6.0f, 4.5f}, {0.85f, 0.82f, 0.76f}},
                    {{5.0f, 4.0f, 3.0f}, {0.32f, 0.34f, 0.40f}}};
    scene.camera = {{0.9f, 2.4f, 6.2f}, {0.1f, 0.85f, -0.2f}, {0.0f, 1.0f, 0.0f}, 40.0f};
    scene.background = {0.20f, 0.30f, 0.45f};
    return scene;
}

} // namespace raysteps
