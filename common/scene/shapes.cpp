#include "scene/shapes.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace raysteps {

namespace {

// The icosahedron's corners on the unit sphere; the golden ratio places them (Euclid, Elements
// XIII).
std::array<glm::vec3, 12> icosahedron_corners() {
    const float golden = (1.0f + std::sqrt(5.0f)) / 2.0f;
    std::array<glm::vec3, 12> corners = {{
        {-1, golden, 0},
        {1, golden, 0},
        {-1, -golden, 0},
        {1, -golden, 0},
        {0, -1, golden},
        {0, 1, golden},
        {0, -1, -golden},
        {0, 1, -golden},
        {golden, 0, -1},
        {golden, 0, 1},
        {-golden, 0, -1},
        {-golden, 0, 1},
    }};
    for (glm::vec3& corner : corners) {
        corner = glm::normalize(corner);
    }
    return corners;
}

constexpr std::array<int, 60> icosahedron_faces = {
    0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
    4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
    6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1,
};

std::vector<glm::vec3> unit_icosahedron() {
    const std::array<glm::vec3, 12> corners = icosahedron_corners();
    std::vector<glm::vec3> triangles;
    triangles.reserve(icosahedron_faces.size());
    for (const int index : icosahedron_faces) {
        triangles.push_back(corners[index]);
    }
    return triangles;
}

// The corners of the triangle cut into divisions * divisions smaller ones, moved onto the unit
// sphere. A corner on an edge has the same bits from both sides: of its three weights one is zero,
// and the sum of two numbers does not depend on their order.
std::vector<glm::vec3> divide(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                              int divisions) {
    const auto point = [&](int toward_b, int toward_c) {
        const auto weight_a = static_cast<float>(divisions - toward_b - toward_c);
        return glm::normalize(weight_a * a + static_cast<float>(toward_b) * b +
                              static_cast<float>(toward_c) * c);
    };
    std::vector<glm::vec3> corners;
    for (int j = 0; j < divisions; ++j) {
        for (int i = 0; i + j < divisions; ++i) {
            corners.insert(corners.end(), {point(i, j), point(i + 1, j), point(i, j + 1)});
            if (i + j + 1 < divisions) {
                corners.insert(corners.end(),
                               {point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
            }
        }
    }
    return corners;
}

} // namespace

Mesh triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    return {{a, b, c}, {normal, normal, normal}};
}

Mesh quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    return join(triangle(a, b, c), triangle(a, c, d));
}

Mesh box(const glm::vec3& lower, const glm::vec3& upper) {
    const auto corner = [&](int x, int y, int z) {
        return glm::vec3(x == 0 ? lower.x : upper.x, y == 0 ? lower.y : upper.y,
                         z == 0 ? lower.z : upper.z);
    };
    Mesh mesh = quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
    mesh = join(std::move(mesh),
                quad(corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0)));
    mesh = join(std::move(mesh),
                quad(corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1)));
    mesh = join(std::move(mesh),
                quad(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0)));
    mesh = join(std::move(mesh),
                quad(corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0)));
    return join(std::move(mesh),
                quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)));
}

Mesh tetrahedron(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    return join(join(triangle(a, b, c), triangle(a, c, d)),
                join(triangle(a, d, b), triangle(b, d, c)));
}

Mesh icosahedron(const glm::vec3& center, float radius) {
    const std::vector<glm::vec3> unit = unit_icosahedron();
    Mesh mesh;
    for (std::size_t i = 0; i < unit.size(); i += 3) {
        mesh =
            join(std::move(mesh), triangle(center + radius * unit[i], center + radius * unit[i + 1],
                                           center + radius * unit[i + 2]));
    }
    return mesh;
}

Mesh sphere(const glm::vec3& center, float radius, int divisions) {
    const std::vector<glm::vec3> unit = unit_icosahedron();
    Mesh mesh;
    for (std::size_t i = 0; i < unit.size(); i += 3) {
        for (const glm::vec3& normal : divide(unit[i], unit[i + 1], unit[i + 2], divisions)) {
            mesh.corners.push_back(center + radius * normal);
            mesh.normals.push_back(normal);
        }
    }
    return mesh;
}

} // namespace raysteps
