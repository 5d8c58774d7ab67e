#include "hard_cases/coincident.h"

#include "hard_cases/loose_triangles.h"

#include <algorithm>
#include <numeric>

namespace raysteps {

Mesh copies_of_a_triangle(int count) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < count; ++i) {
        corners.insert(corners.end(),
                       {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.5f}, {0.0f, 1.0f, 0.25f}});
    }
    return mesh_of(std::move(corners));
}

Mesh tripled(const Mesh& mesh) {
    Mesh turned = mesh;
    for (std::size_t i = 0; i < turned.corners.size(); i += 3) {
        std::swap(turned.corners[i + 1], turned.corners[i + 2]);
    }
    return join(join(mesh, mesh), turned);
}

Mesh reordered(const Mesh& mesh, TriangleOrder order, int seed) {
    std::vector<std::size_t> places(mesh.corners.size() / 3);
    std::iota(places.begin(), places.end(), std::size_t{0});
    if (order == TriangleOrder::backward) {
        std::reverse(places.begin(), places.end());
    }
    if (order == TriangleOrder::shuffled) {
        RandomNumbers numbers(seed);
        for (std::size_t i = places.size(); i > 1; --i) {
            std::swap(places[i - 1],
                      places[static_cast<std::size_t>(numbers.below(static_cast<int>(i)))]);
        }
    }
    Mesh result;
    for (const std::size_t place : places) {
        for (std::size_t i = 3 * place; i < 3 * place + 3; ++i) {
            result.corners.push_back(mesh.corners[i]);
            result.normals.push_back(mesh.normals[i]);
        }
    }
    return result;
}

} // namespace raysteps
