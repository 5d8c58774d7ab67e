#include "scene/mesh.h"
#include "scene/samples/samples.h"
#include "scene/shapes.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace raysteps {

namespace {

// The measured spectra under CIE standard illuminant D65 and the CIE 1931 observer (as fitted by
// Wyman, Sloan and Shirley, "Simple analytic approximations to the CIE XYZ color matching
// functions", 2013), as linear RGB.
constexpr glm::vec3 white{0.738f, 0.736f, 0.740f};
constexpr glm::vec3 red{0.489f, 0.051f, 0.051f};
constexpr glm::vec3 green{0.069f, 0.397f, 0.087f};

constexpr float cornell_lamp_height = 548.0f;

// The walls turn their fronts to the room.
Mesh floor_ceiling_and_back() {
    const Mesh floor = quad({552.8f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 559.2f},
                            {549.6f, 0.0f, 559.2f});
    const Mesh ceiling = quad({556.0f, 548.8f, 0.0f}, {556.0f, 548.8f, 559.2f},
                              {0.0f, 548.8f, 559.2f}, {0.0f, 548.8f, 0.0f});
    const Mesh back = quad({549.6f, 0.0f, 559.2f}, {0.0f, 0.0f, 559.2f}, {0.0f, 548.8f, 559.2f},
                           {556.0f, 548.8f, 559.2f});
    return join(join(floor, ceiling), back);
}

Mesh right_wall() {
    return quad({0.0f, 0.0f, 559.2f}, {0.0f, 0.0f, 0.0f}, {0.0f, 548.8f, 0.0f},
                {0.0f, 548.8f, 559.2f});
}

Mesh left_wall() {
    return quad({552.8f, 0.0f, 0.0f}, {549.6f, 0.0f, 559.2f}, {556.0f, 548.8f, 559.2f},
                {556.0f, 548.8f, 0.0f});
}

Mesh lamp() {
    return quad({343.0f, cornell_lamp_height, 227.0f}, {343.0f, cornell_lamp_height, 332.0f},
                {213.0f, cornell_lamp_height, 332.0f}, {213.0f, cornell_lamp_height, 227.0f});
}

// A block of this height over the base, whose corners run counter-clockwise as seen from above.
Mesh block(const std::array<glm::vec3, 4>& base, float height) {
    const glm::vec3 up{0.0f, height, 0.0f};
    Mesh mesh = quad(base[0] + up, base[1] + up, base[2] + up, base[3] + up);
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec3 from = base[i];
        const glm::vec3 to = base[(i + 1) % 4];
        mesh = join(std::move(mesh), quad(from, to, to + up, from + up));
    }
    return mesh;
}

Mesh short_block() {
    return block({{{130.0f, 0.0f, 65.0f},
                   {82.0f, 0.0f, 225.0f},
                   {240.0f, 0.0f, 272.0f},
                   {290.0f, 0.0f, 114.0f}}},
                 165.0f);
}

Mesh tall_block() {
    return block({{{423.0f, 0.0f, 247.0f},
                   {265.0f, 0.0f, 296.0f},
                   {314.0f, 0.0f, 456.0f},
                   {472.0f, 0.0f, 406.0f}}},
                 330.0f);
}

// A film of 25 mm behind a lens of 35 mm.
Camera measured_camera() {
    Camera camera;
    camera.eye = {278.0f, 273.0f, -800.0f};
    camera.target = {278.0f, 273.0f, 0.0f};
    camera.vertical_field_of_view =
        static_cast<float>(glm::degrees(2.0 * std::atan(25.0 / 2.0 / 35.0)));
    return camera;
}

} // namespace

Scene sample_cornell_box() {
    Material lamp_material = matte("lamp", glm::vec3(0.78f));
    lamp_material.emission = {1.0f, 0.95f, 0.85f};

    Scene scene;
    scene = add_mesh(std::move(scene), floor_ceiling_and_back(), matte("white", white));
    scene = add_mesh(std::move(scene), right_wall(), matte("green", green));
    scene = add_mesh(std::move(scene), left_wall(), matte("red", red));
    scene = add_mesh(std::move(scene), short_block(), matte("short block", white));
    scene = add_mesh(std::move(scene), tall_block(), matte("tall block", white));
    scene = add_mesh(std::move(scene), lamp(), lamp_material);
    scene.lights = {{{278.0f, 540.0f, 279.5f}, {0.90f, 0.85f, 0.76f}},
                    {measured_camera().eye, glm::vec3(0.12f)}};
    scene.camera = measured_camera();
    scene.background = glm::vec3(0.0f);
    return scene;
}

namespace {

constexpr float room_lamp_height = 2.58f;

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
                     mirror_material("mirror", glm::vec3(0.0f), glm::vec3(0.9f)));
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
                     mirror_material("gold", {0.10f, 0.07f, 0.02f}, {0.90f, 0.68f, 0.30f}));
    scene = add_mesh(std::move(scene),
                     quad({-0.4f, room_lamp_height, -0.5f}, {0.4f, room_lamp_height, -0.5f},
                          {0.4f, room_lamp_height, 0.3f}, {-0.4f, room_lamp_height, 0.3f}),
                     glowing("lamp", {1.0f, 0.93f, 0.80f}));
    scene.lights = {{{0.0f, room_lamp_height, -0.1f},
                     {0.72f, 0.66f, 0.56f},
                     {0.8f, 0.0f, 0.0f},
                     {0.0f, 0.0f, 0.8f}},
                    {{-9.0f, 6.0f, 2.0f}, {0.55f, 0.52f, 0.46f}},
                    {{0.4f, 1.7f, 2.9f}, glm::vec3(0.14f)}};
    scene.camera = {{0.5f, 1.55f, 3.6f}, {0.1f, 1.1f, -0.5f}, {0.0f, 1.0f, 0.0f}, 46.0f};
    scene.camera.samples = 16;
    scene.sky = Sky{{0.25f, 0.45f, 0.80f}, {0.80f, 0.86f, 0.92f}, {0.25f, 0.32f, 0.18f}};
    return scene;
}

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

namespace {

constexpr float glass_box_lamp_height = 1.99f;

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
    scene =
        add_mesh(std::move(scene),
                 quad({-0.25f, glass_box_lamp_height, -0.3f}, {0.25f, glass_box_lamp_height, -0.3f},
                      {0.25f, glass_box_lamp_height, 0.2f}, {-0.25f, glass_box_lamp_height, 0.2f}),
                 glowing("lamp", {1.0f, 0.96f, 0.88f}));
    scene = add_mesh(std::move(scene), sphere({-0.42f, 0.4f, -0.42f}, 0.38f, 14),
                     mirror_material("silver", glm::vec3(0.02f), {0.93f, 0.94f, 0.95f}));
    scene = add_mesh(std::move(scene), sphere({0.42f, 0.38f, 0.2f}, 0.36f, 14),
                     glass("glass", 1.5f, {0.86f, 0.96f, 0.92f}));
    scene.lights = {{{0.0f, glass_box_lamp_height, -0.05f},
                     {0.85f, 0.81f, 0.74f},
                     {0.5f, 0.0f, 0.0f},
                     {0.0f, 0.0f, 0.5f}},
                    {{0.0f, 1.2f, 3.9f}, glm::vec3(0.16f)}};
    scene.camera = {{0.0f, 1.0f, 4.1f}, {0.0f, 0.98f, 0.0f}, {0.0f, 1.0f, 0.0f}, 38.0f};
    scene.background = glm::vec3(0.02f);
    return scene;
}

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
    const Material silver = mirror_material("silver", glm::vec3(0.03f), {0.88f, 0.89f, 0.90f});
    const Material gold = mirror_material("gold", {0.10f, 0.07f, 0.02f}, {0.90f, 0.68f, 0.30f});
    const Material copper = mirror_material("copper", {0.08f, 0.04f, 0.03f}, {0.85f, 0.50f, 0.40f});

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

Scene sample_lens() {
    Scene scene;
    scene = add_mesh(std::move(scene), quad({-20, 0, 8}, {20, 0, 8}, {20, 0, -30}, {-20, 0, -30}),
                     painted("floor", "made:checker"));
    scene = map_flat(std::move(scene), 0, 6.0f);
    constexpr int sharp = 2;
    for (int i = 0; i < 7; ++i) {
        const auto place = static_cast<float>(i);
        const glm::vec3 color =
            i == sharp ? glm::vec3(0.70f, 0.10f, 0.08f) : glm::vec3(0.20f, 0.38f, 0.55f);
        scene = add_mesh(std::move(scene),
                         sphere({-2.1f + 0.9f * place, 0.61f, 3.0f - 2.0f * place}, 0.6f, 10),
                         glossy("ball " + std::to_string(i + 1), color, 0.5f, 80.0f));
    }
    scene.lights = {{{-5.0f, 8.0f, 6.0f}, {0.88f, 0.84f, 0.78f}},
                    {{6.0f, 4.0f, 8.0f}, {0.20f, 0.22f, 0.26f}}};
    scene.camera = {{0.0f, 1.7f, 8.0f}, {0.0f, 0.7f, -1.0f}, {0.0f, 1.0f, 0.0f}, 34.0f};
    scene.camera.aperture = 0.45f;
    scene.camera.focus_distance = 9.0f; // the red ball is 9 before the eye
    scene.camera.samples = 32;
    scene.sky = Sky{{0.16f, 0.28f, 0.55f}, {0.66f, 0.72f, 0.78f}, {0.30f, 0.28f, 0.25f}};
    return scene;
}

Scene sample_pictures() {
    Scene scene;
    scene = add_flat(std::move(scene), quad({-8, 0, 8}, {8, 0, 8}, {8, 0, -3}, {-8, 0, -3}),
                     painted("floor", "made:wood"), 2.0f);
    scene = add_flat(std::move(scene), quad({-8, 0, -3}, {8, 0, -3}, {8, 6, -3}, {-8, 6, -3}),
                     painted("wall", "made:bricks"), 2.0f);
    scene = add_flat(std::move(scene), box({1.2f, 0.01f, -1.0f}, {2.6f, 1.41f, 0.4f}),
                     painted("box", "made:checker"), 1.4f);
    const glm::vec3 center{-0.7f, 1.26f, -0.2f};
    const int globe = triangle_count(scene);
    Material earth = painted("globe", "made:globe");
    earth.specular = glm::vec3(0.5f);
    earth.shininess = 60.0f;
    earth.illumination_model = 2;
    scene = add_mesh(std::move(scene), sphere(center, 1.25f, 14), earth);
    scene = map_around(std::move(scene), globe, center);
    scene.lights = {{{-4.5f, 6.0f, 5.0f}, {0.85f, 0.81f, 0.75f}},
                    {{5.0f, 3.5f, 5.0f}, {0.28f, 0.30f, 0.35f}}};
    scene.camera = {{1.0f, 2.5f, 7.4f}, {0.35f, 1.25f, -0.4f}, {0.0f, 1.0f, 0.0f}, 38.0f};
    scene.background = {0.10f, 0.13f, 0.19f};
    return scene;
}

namespace {

glm::vec2 flat_coordinate(const glm::vec3& point, const glm::vec3& normal, float size) {
    const glm::vec3 facing = glm::abs(normal);
    if (facing.y >= facing.x && facing.y >= facing.z) {
        return glm::vec2(point.x, -point.z) / size;
    }
    return (facing.x >= facing.z ? glm::vec2(point.z, point.y) : glm::vec2(point.x, point.y)) /
           size;
}

glm::vec2 round_coordinate(const glm::vec3& direction) {
    constexpr float pi = std::numbers::pi_v<float>;
    const float longitude = std::atan2(direction.x, direction.z);
    return {0.5f + longitude / (2.0f * pi), 0.5f + std::asin(direction.y) / pi};
}

} // namespace

Scene map_flat(Scene scene, int first, float size) {
    for (auto corner = 3 * static_cast<std::size_t>(first); corner < scene.corners.size();
         ++corner) {
        const std::size_t a = corner / 3 * 3;
        const glm::vec3 normal = glm::cross(scene.corners[a + 1] - scene.corners[a],
                                            scene.corners[a + 2] - scene.corners[a]);
        scene.texture_coordinates[corner] = flat_coordinate(scene.corners[corner], normal, size);
    }
    return scene;
}

Scene map_around(Scene scene, int first, const glm::vec3& center) {
    for (auto a = 3 * static_cast<std::size_t>(first); a < scene.corners.size(); a += 3) {
        for (std::size_t corner = a; corner < a + 3; ++corner) {
            glm::vec2 place = round_coordinate(glm::normalize(scene.corners[corner] - center));
            // A triangle over the seam goes on beyond the texture's edge, not back through it all.
            if (corner > a) {
                place.x += std::round(scene.texture_coordinates[a].x - place.x);
            }
            scene.texture_coordinates[corner] = place;
        }
    }
    return scene;
}

} // namespace raysteps
