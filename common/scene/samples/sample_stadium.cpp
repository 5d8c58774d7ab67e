#include "scene/sample_stadium.h"

#include "scene/mesh.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"
#include "scene/torus_knot.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace raysteps {

namespace {

constexpr int segments = 52; // of the ring around
constexpr int steps = 10;    // of the stands
constexpr float half_length = 70.0f;
constexpr float half_width = 50.0f; // of the ground inside the stands
constexpr float step_depth = 3.0f;
constexpr float step_height = 2.2f;

// A point of the oval ring: the segment says where on it, the distance how far outside the ground.
glm::vec3 ring_point(int segment, float distance, float height) {
    const double angle = 2.0 * std::numbers::pi * (segment % segments) / segments;
    return {(half_length + distance) * static_cast<float>(std::cos(angle)), height,
            (half_width + distance) * static_cast<float>(std::sin(angle))};
}

Mesh ground() {
    Mesh mesh;
    for (int i = 0; i < segments; ++i) {
        mesh = join(std::move(mesh), triangle(glm::vec3(0.0f), ring_point(i + 1, 0.0f, 0.0f),
                                              ring_point(i, 0.0f, 0.0f)));
    }
    return mesh;
}

// Risers and treads of the steps whose number has this remainder by two.
Mesh stands(int remainder) {
    Mesh mesh;
    for (int step = remainder; step < steps; step += 2) {
        const float near = step_depth * static_cast<float>(step);
        const float far = step_depth * static_cast<float>(step + 1);
        const float low = step_height * static_cast<float>(step);
        const float high = step_height * static_cast<float>(step + 1);
        for (int i = 0; i < segments; ++i) {
            const glm::vec3 near_high = ring_point(i, near, high);
            const glm::vec3 next_near_high = ring_point(i + 1, near, high);
            mesh =
                join(std::move(mesh), quad(ring_point(i, near, low), ring_point(i + 1, near, low),
                                           next_near_high, near_high));
            mesh =
                join(std::move(mesh), quad(near_high, next_near_high, ring_point(i + 1, far, high),
                                           ring_point(i, far, high)));
        }
    }
    return mesh;
}

// Ten mown stripes of a pitch of 105 by 68 metres; it lies 2 cm over the ground.
Mesh stripes(int remainder) {
    Mesh mesh;
    const float height = 0.02f;
    for (int i = remainder; i < 10; i += 2) {
        const float left = -52.5f + 10.5f * static_cast<float>(i);
        const float right = left + 10.5f;
        mesh = join(std::move(mesh), quad({left, height, 34.0f}, {right, height, 34.0f},
                                          {right, height, -34.0f}, {left, height, -34.0f}));
    }
    return mesh;
}

// The knot, 41 cm wide, 5 cm over the pitch.
Mesh small_knot(int size) {
    Mesh mesh = torus_knot(size);
    for (glm::vec3& corner : mesh.corners) {
        corner = 0.1f * corner + glm::vec3(0.0f, 0.26f, 0.0f);
    }
    return mesh;
}

} // namespace

Scene sample_stadium(int size) {
    Scene scene;
    scene = add_mesh(std::move(scene), ground(), matte("ground", {0.35f, 0.25f, 0.18f}));
    scene = add_mesh(std::move(scene), stripes(0), matte("light grass", {0.22f, 0.45f, 0.12f}));
    scene = add_mesh(std::move(scene), stripes(1), matte("dark grass", {0.15f, 0.34f, 0.09f}));
    scene = add_mesh(std::move(scene), stands(0), matte("concrete", glm::vec3(0.55f)));
    scene = add_mesh(std::move(scene), stands(1), matte("seats", {0.18f, 0.28f, 0.55f}));
    scene = add_mesh(std::move(scene), small_knot(size), matte("trophy", {0.80f, 0.55f, 0.15f}));
    scene.lights = {{{-60.0f, 90.0f, 70.0f}, {0.85f, 0.82f, 0.76f}},
                    {{80.0f, 70.0f, 60.0f}, {0.28f, 0.30f, 0.35f}}};
    scene.camera = {{0.25f, 0.42f, 0.95f}, {0.0f, 0.27f, 0.0f}, {0.0f, 1.0f, 0.0f}, 50.0f};
    scene.background = {0.25f, 0.38f, 0.60f};
    return scene;
}

} // namespace raysteps
