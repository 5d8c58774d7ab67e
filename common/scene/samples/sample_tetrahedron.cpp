#include "scene/sample_tetrahedron.h"

#include "scene/mesh.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace raysteps {

namespace {

using Tetrahedron = std::array<glm::vec3, 4>;

// The four tetrahedra of half the size in its corners. They touch in the middles of its edges.
std::array<Tetrahedron, 4> halve(const Tetrahedron& corners) {
    std::array<Tetrahedron, 4> smaller;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            smaller[i][j] = 0.5f * (corners[i] + corners[j]);
        }
    }
    return smaller;
}

} // namespace

Scene sample_tetrahedron(int depth) {
    const float side = std::sqrt(3.0f) / 2.0f;
    std::vector<Tetrahedron> tetrahedra = {{{{0.0f, 0.0f, 1.0f},
                                             {-side, 0.0f, -0.5f},
                                             {side, 0.0f, -0.5f},
                                             {0.0f, std::sqrt(2.0f), 0.0f}}}};
    for (int level = 0; level < depth; ++level) {
        std::vector<Tetrahedron> smaller;
        for (const Tetrahedron& corners : tetrahedra) {
            const std::array<Tetrahedron, 4> halves = halve(corners);
            smaller.insert(smaller.end(), halves.begin(), halves.end());
        }
        tetrahedra = std::move(smaller);
    }
    Mesh mesh;
    for (const Tetrahedron& corners : tetrahedra) {
        mesh = join(std::move(mesh), tetrahedron(corners[0], corners[1], corners[2], corners[3]));
    }
    return add_mesh({}, mesh, matte("gold", {0.75f, 0.50f, 0.15f}));
}

} // namespace raysteps
