#include "scene/sample_needles.h"

#include "scene/mesh.h"
#include "scene/random_numbers.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"

#include <glm/geometric.hpp>

#include <array>
#include <utility>

namespace raysteps {

namespace {

constexpr float shortest = 0.5f;
constexpr float longest = 1.0f;
constexpr float thickest = 0.02f; // in lengths of the needle
constexpr float thinnest = 0.0002f;

// Of length 1. Points outside the ball, which would favour the cube's corners, are drawn again, as
// are those next to its centre, whose direction is rounded.
glm::vec3 random_direction(RandomNumbers& random) {
    for (;;) {
        const glm::vec3 point = random.in_cube();
        const float squared = glm::dot(point, point);
        if (squared <= 1.0f && squared > 0.01f) {
            return glm::normalize(point);
        }
    }
}

Mesh random_needle(RandomNumbers& random) {
    const glm::vec3 center = 0.5f * random.in_cube();
    const glm::vec3 direction = random_direction(random);
    const float length = shortest + (longest - shortest) * random.unit();
    const float share = random.unit();
    const float width = length * (thinnest + (thickest - thinnest) * share * share * share);
    for (;;) {
        const glm::vec3 across = glm::cross(direction, random_direction(random));
        if (glm::dot(across, across) > 0.01f) {
            const glm::vec3 half_width = 0.5f * width * glm::normalize(across);
            const glm::vec3 half_length = 0.5f * length * direction;
            return triangle(center - half_length - half_width, center - half_length + half_width,
                            center + half_length);
        }
    }
}

} // namespace

Scene sample_needles(int count, int seed) {
    RandomNumbers random(seed);
    std::array<Mesh, 2> meshes;
    for (int i = 0; i < count; ++i) {
        Mesh& mesh = meshes[static_cast<std::size_t>(random.below(2))];
        mesh = join(std::move(mesh), random_needle(random));
    }
    Scene scene = add_mesh({}, meshes[0], matte("pine", {0.15f, 0.45f, 0.20f}));
    return add_mesh(std::move(scene), meshes[1], matte("straw", {0.75f, 0.65f, 0.30f}));
}

} // namespace raysteps
