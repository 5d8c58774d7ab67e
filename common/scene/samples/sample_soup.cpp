#include "scene/sample_soup.h"

#include "scene/mesh.h"
#include "scene/random_numbers.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace raysteps {

namespace {

// Falls with the cube root of the count, found in whole numbers: std::cbrt may differ between
// machines.
float triangle_size(int count) {
    long long side = 1;
    while (side * side * side < count) {
        ++side;
    }
    return std::min(0.75f, 1.5f / static_cast<float>(side));
}

// A triangle without an area is thrown away and drawn again.
Mesh random_triangle(RandomNumbers& random, float size) {
    for (;;) {
        const glm::vec3 center = random.in_cube() * (1.0f - size);
        const glm::vec3 a = center + size * random.in_cube();
        const glm::vec3 b = center + size * random.in_cube();
        const glm::vec3 c = center + size * random.in_cube();
        if (glm::length(glm::cross(b - a, c - a)) > 0.0f) {
            return triangle(a, b, c);
        }
    }
}

} // namespace

Scene sample_soup(int count, int seed) {
    RandomNumbers random(seed);
    const float size = triangle_size(count);
    std::array<Mesh, 4> meshes;
    for (int i = 0; i < count; ++i) {
        Mesh& mesh = meshes[static_cast<std::size_t>(random.below(4))];
        mesh = join(std::move(mesh), random_triangle(random, size));
    }
    Scene scene;
    scene = add_mesh(std::move(scene), meshes[0], matte("carrot", {0.75f, 0.30f, 0.08f}));
    scene = add_mesh(std::move(scene), meshes[1], matte("leek", {0.35f, 0.55f, 0.15f}));
    scene = add_mesh(std::move(scene), meshes[2], matte("potato", {0.70f, 0.60f, 0.35f}));
    return add_mesh(std::move(scene), meshes[3], matte("beetroot", {0.45f, 0.08f, 0.20f}));
}

} // namespace raysteps
