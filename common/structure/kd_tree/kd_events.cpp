#include "structure/kd_tree/kd_split.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace raysteps {

namespace {

// Each of six planes adds at most one corner to a triangle: 9 in all. Rounding may dent a polygon
// by a hair; even one that crosses a plane as often as it can grows by half at most: 3, 4, 6, 9,
// 13, 19, 28.
struct Polygon {
    std::array<glm::dvec3, 28> corners;
    std::size_t count = 0;
};

// Where the edge from a to b, which crosses the plane, meets it.
glm::dvec3 crossing(const glm::dvec3& a, const glm::dvec3& b, int axis, double plane) {
    glm::dvec3 point = a + (plane - a[axis]) / (b[axis] - a[axis]) * (b - a);
    point[axis] = plane;
    return point;
}

enum class Side { lower, upper };

bool is_on(Side side, double coordinate, double plane) {
    return side == Side::lower ? coordinate <= plane : coordinate >= plane;
}

// What of the polygon lies on that side of the plane.
Polygon kept(const Polygon& polygon, int axis, double plane, Side side) {
    Polygon rest;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec3& a = polygon.corners[i];
        const glm::dvec3& b = polygon.corners[(i + 1) % polygon.count];
        const bool a_stays = is_on(side, a[axis], plane);
        if (a_stays) {
            rest.corners[rest.count++] = a;
        }
        if (a_stays != is_on(side, b[axis], plane)) {
            rest.corners[rest.count++] = crossing(a, b, axis, plane);
        }
    }
    return rest;
}

float below(double value) {
    return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::infinity());
}

float above(double value) {
    return std::nextafter(static_cast<float>(value), +std::numeric_limits<float>::infinity());
}

} // namespace

ExactBox grown(const Box& box, double padding) {
    return {glm::dvec3(box.lower) - padding, glm::dvec3(box.upper) + padding};
}

Box clipped_bounds(const std::array<glm::vec3, 3>& triangle, const ExactBox& box, double padding) {
    Polygon polygon;
    for (const glm::vec3& corner : triangle) {
        polygon.corners[polygon.count++] = corner;
    }
    for (int axis = 0; axis < 3; ++axis) {
        polygon = kept(polygon, axis, box.lower[axis], Side::upper);
        polygon = kept(polygon, axis, box.upper[axis], Side::lower);
    }
    if (polygon.count == 0) {
        return {};
    }
    ExactBox bounds{polygon.corners[0], polygon.corners[0]};
    for (std::size_t i = 1; i < polygon.count; ++i) {
        bounds.lower = glm::min(bounds.lower, polygon.corners[i]);
        bounds.upper = glm::max(bounds.upper, polygon.corners[i]);
    }
    Box rounded;
    for (int axis = 0; axis < 3; ++axis) {
        rounded.lower[axis] = below(bounds.lower[axis] - padding);
        rounded.upper[axis] = above(bounds.upper[axis] + padding);
    }
    return rounded;
}

namespace {

bool comes_before(const KdEvent& a, const KdEvent& b) {
    return a.position < b.position || (a.position == b.position && a.code < b.code);
}

} // namespace

KdEvents events_in(const KdTriangles& triangles, std::span<const int> chosen, const Box& box) {
    const ExactBox around = grown(box, triangles.padding);
    KdEvents events;
    for (std::vector<KdEvent>& along_axis : events) {
        along_axis.reserve(2 * chosen.size());
    }
    for (const int triangle : chosen) {
        const Box bounds =
            clipped_bounds(triangle_at(triangles, triangle), around, triangles.padding);
        if (is_empty(bounds)) {
            continue;
        }
        for (int axis = 0; axis < 3; ++axis) {
            events[axis].push_back(make_event(bounds.lower[axis], triangle, KdEventKind::start));
            events[axis].push_back(make_event(bounds.upper[axis], triangle, KdEventKind::end));
        }
    }
    for (std::vector<KdEvent>& along_axis : events) {
        std::sort(along_axis.begin(), along_axis.end(), comes_before);
    }
    return events;
}

std::vector<KdPart> parts_in(const KdTriangles& triangles, const Box& box) {
    const ExactBox around = grown(box, triangles.padding);
    const auto count = static_cast<int>(triangles.corners.size() / 3);
    std::vector<KdPart> parts;
    parts.reserve(triangles.corners.size() / 3);
    for (int triangle = 0; triangle < count; ++triangle) {
        const Box bounds =
            clipped_bounds(triangle_at(triangles, triangle), around, triangles.padding);
        if (!is_empty(bounds)) {
            parts.push_back({bounds, triangle});
        }
    }
    return parts;
}

KdEvents events_of(std::span<const KdPart> parts) {
    KdEvents events;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<KdEvent>& along_axis = events[static_cast<std::size_t>(axis)];
        along_axis.reserve(2 * parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto place = static_cast<int>(i);
            along_axis.push_back(
                make_event(parts[i].bounds.lower[axis], place, KdEventKind::start));
            along_axis.push_back(make_event(parts[i].bounds.upper[axis], place, KdEventKind::end));
        }
        std::sort(along_axis.begin(), along_axis.end(), comes_before);
    }
    return events;
}

KdEvents merge_events(KdEvents own, KdEvents cut) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (cut[axis].empty()) {
            continue;
        }
        std::vector<KdEvent> merged(own[axis].size() + cut[axis].size());
        std::merge(own[axis].begin(), own[axis].end(), cut[axis].begin(), cut[axis].end(),
                   merged.begin(), comes_before);
        own[axis] = std::move(merged);
    }
    return own;
}

} // namespace raysteps
