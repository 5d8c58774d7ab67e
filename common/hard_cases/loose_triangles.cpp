#include "hard_cases/loose_triangles.h"

#include <glm/geometric.hpp>

namespace raysteps {

Mesh mesh_of(std::vector<glm::vec3> corners) {
    Mesh mesh;
    mesh.corners = std::move(corners);
    for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3) {
        const glm::dvec3 a(mesh.corners[i]);
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(mesh.corners[i + 1]) - a, glm::dvec3(mesh.corners[i + 2]) - a);
        const double length = glm::length(normal);
        const glm::vec3 unit =
            length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f, 0.0f, 1.0f);
        mesh.normals.insert(mesh.normals.end(), 3, unit);
    }
    return mesh;
}

Mesh random_triangles(RandomNumbers& numbers, int count) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = numbers.in_cube();
        for (int corner = 0; corner < 3; ++corner) {
            corners.push_back(center + 0.3f * numbers.in_cube());
        }
    }
    return mesh_of(std::move(corners));
}

Mesh random_slivers(RandomNumbers& numbers, int count) {
    std::vector<glm::vec3> corners = random_triangles(numbers, count).corners;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        corners[i + 1] = corners[i] + 2.0f * numbers.in_cube();
        corners[i + 2] = corners[i] + 0.001f * numbers.in_cube();
    }
    return mesh_of(std::move(corners));
}

Mesh flattened(Mesh mesh, int axis, float place) {
    for (glm::vec3& corner : mesh.corners) {
        corner[axis] = place;
    }
    return mesh_of(std::move(mesh.corners));
}

} // namespace raysteps
