#include "scene/sample_mirrors.h"

#include "scene/mesh.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"

#include <utility>

namespace raysteps {

namespace {

constexpr int rows = 8;
constexpr int columns = 12;

// The tiles whose column and row add up to this remainder by two.
Mesh tiles(int remainder) {
    Mesh mesh;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            if ((row + column) % 2 != remainder) {
                continue;
            }
            const float left = static_cast<float>(column) - 0.5f * columns;
            const float back = static_cast<float>(row) - 0.5f * rows;
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
    scene = add_mesh(std::move(scene), tiles(0), matte("light tile", {0.75f, 0.72f, 0.66f}));
    scene = add_mesh(std::move(scene), tiles(1), matte("dark tile", {0.12f, 0.14f, 0.18f}));
    scene = add_mesh(std::move(scene), sphere({-0.95f, 1.11f, -0.7f}, 1.1f, 6), silver);
    scene = add_mesh(std::move(scene), sphere({1.25f, 0.76f, -0.4f}, 0.75f, 4), gold);
    scene = add_mesh(std::move(scene), sphere({0.15f, 0.41f, 1.1f}, 0.4f, 3), copper);
    // The wall's mirror hangs in a frame, which sticks out in front of the wall.
    scene = add_mesh(std::move(scene), box({-6.0f, 0.01f, -4.2f}, {6.0f, 3.9f, -4.0f}),
                     matte("wall", {0.62f, 0.50f, 0.36f}));
    scene = add_mesh(std::move(scene), box({-1.6f, 0.3f, -3.99f}, {3.3f, 3.3f, -3.95f}),
                     matte("frame", {0.18f, 0.09f, 0.05f}));
    scene = add_mesh(std::move(scene), box({-1.45f, 0.45f, -3.94f}, {3.15f, 3.15f, -3.9f}), silver);
    scene = add_mesh(std::move(scene), icosahedron({-1.35f, 0.5f, 1.3f}, 0.5f),
                     matte("blue", {0.08f, 0.22f, 0.70f}));
    scene = add_mesh(std::move(scene), box({2.3f, 0.01f, -2.2f}, {3.1f, 1.7f, -1.4f}),
                     matte("green", {0.12f, 0.50f, 0.18f}));
    scene = add_mesh(std::move(scene), box({1.25f, 0.01f, 0.9f}, {1.85f, 0.61f, 1.5f}),
                     matte("red", {0.72f, 0.10f, 0.08f}));
    scene.lights = {{{-3.5f, 5.5f, 4.5f}, {0.80f, 0.76f, 0.70f}},
                    {{4.5f, 4.0f, 4.0f}, {0.30f, 0.32f, 0.38f}}};
    scene.camera = {{0.6f, 2.7f, 6.6f}, {0.15f, 0.95f, -0.4f}, {0.0f, 1.0f, 0.0f}, 40.0f};
    scene.background = {0.20f, 0.30f, 0.45f};
    return scene;
}

} // namespace raysteps
