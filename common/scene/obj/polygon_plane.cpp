#include "scene/polygon_plane.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace raysteps {

namespace {

// Twice the polygon's area, as a vector. Around the first corner, so that a polygon that is far
// from the origin loses nothing to rounding.
glm::dvec3 mean_normal(std::span<const glm::vec3> corners) {
    const glm::dvec3 origin = corners.front();
    glm::dvec3 sum{0.0};
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += glm::cross(glm::dvec3(corners[i - 1]) - origin, glm::dvec3(corners[i]) - origin);
    return sum;
}

} // namespace

std::vector<glm::dvec2> flatten_polygon(std::span<const glm::vec3> corners) {
    const glm::dvec3 normal = mean_normal(corners);
    const glm::dvec3 size = glm::abs(normal);
    int axis = size.x > size.y ? 0 : 1;
    axis = size[axis] > size.z ? axis : 2;
    const int other = normal[axis] < 0.0 ? 2 : 1;
    const int right = (axis + other) % 3;
    const int up = (axis + 3 - other) % 3;

    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    for (const glm::vec3& corner : corners)
        flat.emplace_back(corner[right], corner[up]);
    return flat;
}

} // namespace raysteps
