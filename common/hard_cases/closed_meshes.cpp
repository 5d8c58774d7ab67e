#include "hard_cases/closed_meshes.h"

#include "scene/shapes.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace raysteps {

namespace {

constexpr double pi = 3.14159265358979323846;

// On the sphere of radius 1. Rows run from pole to pole; the last place of a row is its first.
glm::vec3 place_on_sphere(int row, int rows, int column, int around) {
    const double down = pi * row / rows;
    const double round = 2.0 * pi * (column % around) / around;
    const double sine = row == 0 || row == rows ? 0.0 : std::sin(down);
    return glm::vec3(sine * std::cos(round), std::cos(down), sine * std::sin(round));
}

} // namespace

Mesh latitude_sphere(float radius, int rows, int around) {
    Mesh mesh;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        for (const glm::vec3& corner : {a, b, c}) {
            mesh.corners.push_back(radius * corner);
            mesh.normals.push_back(corner);
        }
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < around; ++column) {
            const glm::vec3 a = place_on_sphere(row, rows, column, around);
            const glm::vec3 b = place_on_sphere(row, rows, column + 1, around);
            const glm::vec3 c = place_on_sphere(row + 1, rows, column + 1, around);
            const glm::vec3 d = place_on_sphere(row + 1, rows, column, around);
            if (row > 0) {
                add(a, b, c);
            }
            if (row + 1 < rows) {
                add(a, c, d);
            }
        }
    }
    return mesh;
}

Mesh shared_edge_sphere() {
    return latitude_sphere(2.0f, 20, 40);
}

Mesh sliver_ball(float times) {
    Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 4);
    for (glm::vec3& corner : mesh.corners) {
        corner.x *= times;
    }
    return mesh;
}

Mesh flat_lens(float height) {
    Mesh mesh = latitude_sphere(1.0f, 12, 24);
    for (glm::vec3& corner : mesh.corners) {
        corner.y *= height;
    }
    return mesh;
}

Mesh scaled_and_moved(Mesh mesh, float scale, const glm::vec3& offset) {
    for (glm::vec3& corner : mesh.corners) {
        corner = scale * corner + offset;
    }
    return mesh;
}

} // namespace raysteps
