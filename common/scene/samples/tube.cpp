#include "scene/tube.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace raysteps {

Mesh closed_tube(const std::vector<TubeSection>& sections, double radius, int sides) {
    const int rings = static_cast<int>(sections.size());
    Mesh points; // one corner and normal for each section and side
    for (const TubeSection& section : sections) {
        for (int side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            const glm::dvec3 normal =
                std::cos(angle) * section.right + std::sin(angle) * section.up;
            points.corners.push_back(glm::vec3(section.center + radius * normal));
            points.normals.push_back(glm::vec3(normal));
        }
    }
    Mesh mesh;
    const auto add_corner = [&](int ring, int side) {
        const int index = ring % rings * sides + side % sides;
        mesh.corners.push_back(points.corners[static_cast<std::size_t>(index)]);
        mesh.normals.push_back(points.normals[static_cast<std::size_t>(index)]);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            add_corner(ring, side);
            add_corner(ring, side + 1);
            add_corner(ring + 1, side + 1);
            add_corner(ring, side);
            add_corner(ring + 1, side + 1);
            add_corner(ring + 1, side);
        }
    }
    return mesh;
}

} // namespace raysteps
