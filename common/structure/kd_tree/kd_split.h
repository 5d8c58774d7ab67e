#pragma once

#include "basics/box.h"
#include "structure/kd_tree/kd_tree.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace raysteps {

// In double precision, so that 24-bit corners and planes are clipped almost without rounding.
struct ExactBox {
    glm::dvec3 lower{0.0};
    glm::dvec3 upper{0.0};
};

// The box with its sides moved outwards by the padding.
ExactBox grown(const Box& box, double padding);

// The bounds of that part of the triangle that lies in the box, which is closed, grown by the
// padding and rounded outwards; empty where they do not meet. Source: Sutherland and Hodgman,
// "Reentrant Polygon Clipping", 1974; used so by Havran, "Heuristic Ray Shooting Algorithms", 2000.
Box clipped_bounds(const std::array<glm::vec3, 3>& triangle, const ExactBox& box, double padding);

enum class KdEventKind { end, start };

// Where a plane that sweeps along an axis begins or ends to cut the bounds of a triangle. Bounds
// are padded and so never flat: the events of a triangle that lies in a plane stand apart, and need
// no kind of their own.
struct KdEvent {
    float position = 0.0f;
    std::int32_t code = 0; // 2 * triangle + kind
};

inline KdEvent make_event(float position, int triangle, KdEventKind kind) {
    return {position, 2 * triangle + (kind == KdEventKind::start ? 1 : 0)};
}

inline int triangle_of(const KdEvent& event) {
    return event.code >> 1;
}

inline bool is_start(const KdEvent& event) {
    return (event.code & 1) == 1;
}

// For each axis the events of the same triangles, two a triangle, sorted by position.
using KdEvents = std::array<std::vector<KdEvent>, 3>;

inline std::size_t triangle_count(const KdEvents& events) {
    return events[0].size() / 2;
}

// The triangles' corners, three a triangle, and how far a triangle reaches beyond them.
struct KdTriangles {
    std::span<const glm::vec3> corners;
    double padding = 0.0;
};

inline std::array<glm::vec3, 3> triangle_at(const KdTriangles& triangles, int triangle) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    return {triangles.corners[first], triangles.corners[first + 1], triangles.corners[first + 2]};
}

// Of those parts of the triangles that lie in the box, grown by the padding.
KdEvents events_in(const KdTriangles& triangles, std::span<const int> chosen, const Box& box);

// What is in the box of a child: all events of `own`, which lie on its side of the split, and those
// of `cut`, which are clipped. Both are sorted.
KdEvents merge_events(KdEvents own, KdEvents cut);

// A triangle of a box and the bounds of its part in there, grown by the padding: what is known of
// it where a tree is too large for sorted events.
struct KdPart {
    Box bounds;
    std::int32_t triangle = 0;
};

// Of all triangles.
std::vector<KdPart> parts_in(const KdTriangles& triangles, const Box& box);

// The same as events. Each is called by its place among the parts, not by its triangle.
KdEvents events_of(std::span<const KdPart> parts);

// A plane to split a box at, and how many triangles have a part on each side.
struct KdPlane {
    int axis = -1; // none found
    float position = 0.0f;
    std::size_t lower_count = 0;
    std::size_t upper_count = 0;
    double cost = 0.0; // expected, of a ray through the box
};

inline bool was_found(const KdPlane& plane) {
    return plane.axis >= 0;
}

// A child thinner than this has no plane far enough from its sides to be told apart by rounded
// distances, and nothing to gain: triangles are two paddings thick.
inline constexpr double least_width_in_paddings = 8.0;

// The plane of least cost over all events, by the surface-area heuristic: a ray through the box
// goes through a child with the probability of the ratio of their surfaces, and a split costs
//   traversal_cost + intersection_cost * (p_lower * lower_count + p_upper * upper_count),
// less the bonus where a side is empty. No plane stands so near to a side of the box that a child
// would be thinner than 8 paddings. Source: MacDonald and Booth, "Heuristics for ray tracing using
// space subdivision", 1990; swept as in Wald and Havran, "On building fast kd-trees for ray
// tracing, and on doing that in O(N log N)", 2006.
KdPlane cheapest_plane(const KdEvents& events, const Box& box, double padding,
                       const KdOptions& options);

// The cheapest of 255 planes an axis, of up to 4,096 parts of 63, which stand in equal distances,
// and of those at both ends of the parts. How many parts end before such a plane is counted
// exactly; that costs one look at each part and no order. Source: Hunt, Mark and Stoll, "Fast
// kd-tree Construction with an Adaptive Error-Bounded Heuristic", 2006.
KdPlane binned_plane(std::span<const KdPart> parts, const Box& box, double padding,
                     const KdOptions& options);

// The middle of the longest side, where the children are not too thin.
KdPlane middle_plane(const KdEvents& events, const Box& box, double padding);

} // namespace raysteps
