#include "scene/polygon_triangles.h"

#include "scene/normals.h"
#include "scene/polygon_ears.h"
#include "scene/polygon_plane.h"

namespace raysteps {

namespace {

// The corners that do not stand where the one before them stands.
std::vector<int> different_corners(std::span<const glm::vec3> corners) {
    std::vector<int> different;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (different.empty() || corners[i] != corners[different.back()])
            different.push_back(static_cast<int>(i));
    while (different.size() > 1 && corners[different.front()] == corners[different.back()])
        different.pop_back();
    return different;
}

std::vector<PolygonTriangle> cut_fan(std::size_t corner_count) {
    std::vector<PolygonTriangle> triangles;
    triangles.reserve(corner_count - 2);
    for (int i = 2; i < static_cast<int>(corner_count); ++i)
        triangles.push_back({0, i - 1, i});
    return triangles;
}

bool fan_covers(std::span<const glm::dvec2> points) {
    for (std::size_t i = 2; i < points.size(); ++i)
        if (!(turn(points[0], points[i - 1], points[i]) > 0.0))
            return false;
    return true;
}

std::vector<PolygonTriangle> cut_polygon(std::span<const glm::vec3> corners) {
    if (corners.size() == 3)
        return cut_fan(3);
    const std::vector<glm::dvec2> points = flatten_polygon(corners);
    return fan_covers(points) ? cut_fan(points.size()) : cut_ears(points);
}

} // namespace

std::vector<PolygonTriangle> triangulate_polygon(std::span<const glm::vec3> corners) {
    const std::vector<int> different = different_corners(corners);
    if (different.size() < 3)
        return {};
    std::vector<glm::vec3> polygon;
    polygon.reserve(different.size());
    for (const int corner : different)
        polygon.push_back(corners[corner]);

    std::vector<PolygonTriangle> triangles;
    for (const auto& [a, b, c] : cut_polygon(polygon))
        if (area_vector(polygon[a], polygon[b], polygon[c]) != glm::dvec3(0.0))
            triangles.push_back({different[a], different[b], different[c]});
    return triangles;
}

} // namespace raysteps
