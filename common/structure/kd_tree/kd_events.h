#pragma once

#include "structure/clip_triangle.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace raysteps {

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

} // namespace raysteps
