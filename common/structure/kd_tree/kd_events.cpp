#include "structure/kd_events.h"

#include <algorithm>

namespace raysteps {

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
