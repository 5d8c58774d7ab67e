#include "scene/sample_room.h"

#include "scene/mapping.h"
#include "scene/mesh.h"
#include "scene/sample_surfaces.h"
#include "scene/shapes.h"

#include <utility>

namespace raysteps {

namespace {

constexpr float lamp_height = 2.58f;

Scene add_flat(Scene scene, const Mesh& mesh, const Material& material, float size) {
    const int first = triangle_count(scene);
    return map_flat(add_mesh(std::move(scene), mesh, material), first, size);
}

// The wall on the left, with an opening for the window.
Mesh window_wall() {
    Mesh mesh = quad({-2.5f, 0, 3}, {-2.5f, 0, -2}, {-2.5f, 0.9f, -2}, {-2.5f, 0.9f, 3});
    mesh = join(std::move(mesh),
                quad({-2.5f, 2.2f, 3}, {-2.5f, 2.2f, -2}, {-2.5f, 2.7f, -2}, {-2.5f, 2.7f, 3}));
    mesh = join(std::move(mesh), quad({-2.5f, 0.9f, -1.2f}, {-2.5f, 0.9f, -2}, {-2.5f, 2.2f, -2},
                                      {-2.5f, 2.2f, -1.2f}));
    return join(std::move(mesh),
                quad({-2.5f, 0.9f, 3}, {-2.5f, 0.9f, 0.6f}, {-2.5f, 2.2f, 0.6f}, {-2.5f, 2.2f, 3}));
}

Mesh window_frame() {
    Mesh mesh = box({-2.56f, 0.85f, -1.26f}, {-2.44f, 0.93f, 0.66f});
    mesh = join(std::move(mesh), box({-2.56f, 2.17f, -1.26f}, {-2.44f, 2.25f, 0.66f}));
    mesh = join(std::move(mesh), box({-2.54f, 0.93f, -0.33f}, {-2.46f, 2.17f, -0.27f}));
    return join(std::move(mesh), box({-2.54f, 1.52f, -1.2f}, {-2.46f, 1.58f, 0.6f}));
}

Mesh table() {
    Mesh mesh = box({-0.7f, 0.72f, -0.9f}, {1.3f, 0.8f, 0.2f});
    for (const float x : {-0.62f, 1.12f}) {
        for (const float z : {-0.82f, 0.02f}) {
            mesh = join(std::move(mesh), box({x, 0.002f, z}, {x + 0.1f, 0.719f, z + 0.1f}));
        }
    }
    return mesh;
}

} // namespace

Scene sample_room() {
    Scene scene;
    scene =
        add_flat(std::move(scene), quad({-2.5f, 0, 3}, {2.5f, 0, 3}, {2.5f, 0, -2}, {-2.5f, 0, -2}),
                 painted("floor", "made:wood"), 1.6f);
    scene = add_flat(std::move(scene),
                     quad({-2.5f, 0, -2}, {2.5f, 0, -2}, {2.5f, 2.7f, -2}, {-2.5f, 2.7f, -2}),
                     painted("bricks", "made:bricks"), 1.2f);
    scene =
        add_mesh(std::move(scene),
                 join(quad({-2.5f, 2.7f, -2}, {2.5f, 2.7f, -2}, {2.5f, 2.7f, 3}, {-2.5f, 2.7f, 3}),
                      join(window_wall(),
                           quad({2.5f, 0, -2}, {2.5f, 0, 3}, {2.5f, 2.7f, 3}, {2.5f, 2.7f, -2}))),
                 matte("plaster", {0.74f, 0.70f, 0.62f}));
    scene = add_mesh(std::move(scene), window_frame(), matte("white wood", glm::vec3(0.72f)));
    scene = add_mesh(std::move(scene), table(), glossy("table", {0.36f, 0.18f, 0.09f}, 0.25f, 40));
    scene = add_mesh(std::move(scene), box({0.55f, 1.15f, -1.99f}, {1.95f, 2.25f, -1.95f}),
                     matte("frame", {0.14f, 0.08f, 0.05f}));
    scene = add_mesh(std::move(scene),
                     quad({0.62f, 1.22f, -1.94f}, {1.88f, 1.22f, -1.94f}, {1.88f, 2.18f, -1.94f},
                          {0.62f, 2.18f, -1.94f}),
                     mirror("mirror", glm::vec3(0.0f), glm::vec3(0.9f)));
    scene = add_mesh(std::move(scene), sphere({0.75f, 1.051f, -0.3f}, 0.25f, 12),
                     glass("crystal", 1.6f, {0.9f, 0.95f, 1.0f}));
    scene = add_mesh(std::move(scene), sphere({0.15f, 0.951f, -0.1f}, 0.15f, 10),
                     glass("amber", 1.5f, {0.35f, 0.09f, 0.004f}));
    const glm::vec3 globe_center{-0.3f, 1.051f, -0.55f};
    const int globe = triangle_count(scene);
    scene =
        add_mesh(std::move(scene), sphere(globe_center, 0.25f, 10), painted("globe", "made:globe"));
    scene = map_around(std::move(scene), globe, globe_center);
    scene = add_mesh(std::move(scene), sphere({-1.5f, 0.361f, 0.2f}, 0.36f, 10),
                     mirror("gold", {0.10f, 0.07f, 0.02f}, {0.90f, 0.68f, 0.30f}));
    scene = add_mesh(std::move(scene),
                     quad({-0.4f, lamp_height, -0.5f}, {0.4f, lamp_height, -0.5f},
                          {0.4f, lamp_height, 0.3f}, {-0.4f, lamp_height, 0.3f}),
                     glowing("lamp", {1.0f, 0.93f, 0.80f}));
    scene.lights = {
        {{0.0f, lamp_height, -0.1f}, {0.72f, 0.66f, 0.56f}, {0.8f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.8f}},
        {{-9.0f, 6.0f, 2.0f}, {0.55f, 0.52f, 0.46f}},
        {{0.4f, 1.7f, 2.9f}, glm::vec3(0.14f)}};
    scene.camera = {{0.5f, 1.55f, 3.6f}, {0.1f, 1.1f, -0.5f}, {0.0f, 1.0f, 0.0f}, 46.0f};
    scene.camera.samples = 16;
    scene.sky = Sky{{0.25f, 0.45f, 0.80f}, {0.80f, 0.86f, 0.92f}, {0.25f, 0.32f, 0.18f}};
    return scene;
}

} // namespace raysteps
