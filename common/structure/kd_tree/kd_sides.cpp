#include "structure/kd_sides.h"

namespace raysteps {

std::vector<Sides> sorted_out(std::vector<Sides> sides, const KdEvents& events,
                              const KdPlane& plane) {
    const std::vector<KdEvent>& along_axis = events[static_cast<std::size_t>(plane.axis)];
    for (const KdEvent& event : along_axis) {
        if (is_start(event)) {
            sides[static_cast<std::size_t>(triangle_of(event))] =
                event.position >= plane.position ? Sides::upper : Sides::both;
        }
    }
    for (const KdEvent& event : along_axis) {
        if (!is_start(event) && event.position <= plane.position) {
            sides[static_cast<std::size_t>(triangle_of(event))] = Sides::lower;
        }
    }
    return sides;
}

KdEvents events_on(Sides side, const KdEvents& events, const std::vector<Sides>& sides) {
    KdEvents rest;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const KdEvent& event : events[axis]) {
            if (sides[static_cast<std::size_t>(triangle_of(event))] == side) {
                rest[axis].push_back(event);
            }
        }
    }
    return rest;
}

std::vector<int> triangles_on(Sides side, const KdEvents& events, const std::vector<Sides>& sides) {
    std::vector<int> triangles;
    for (const KdEvent& event : events[0]) {
        const int triangle = triangle_of(event);
        if (is_start(event) && sides[static_cast<std::size_t>(triangle)] == side) {
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

} // namespace raysteps
