#include "octant_places.h"
#include "record_with.h"
#include "recorders.h"

namespace raysteps {

namespace mirror {

template <class Real>
struct BvhSkipRecorded {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_skip.glsl"
#define OBSERVER_PART "visualizer/replay/recorder.inc"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhSkipPaddedRecorded {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_skip_padded.glsl"
#define OBSERVER_PART "visualizer/replay/recorder.inc"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhOrderedRecorded {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_ordered.glsl"
#define OBSERVER_PART "visualizer/replay/recorder.inc"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhParentRecorded {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_parent.glsl"
#define OBSERVER_PART "visualizer/replay/recorder.inc"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhStackRecorded {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_stack.glsl"
#define OBSERVER_PART "visualizer/replay/recorder.inc"
#include "mirror/parts.inc"
};

} // namespace mirror

namespace {

// A box is entered where the ray meets it, and before the best hit so far.
template <class Mirror>
struct ExplainBox {
    static constexpr bool each_test_is_a_step = false;

    ExplainBox(Mirror& mirror, const typename Mirror::Ray& mirror_ray, const RecorderInput& input)
        : t_max(mirror_ray.t_max), boxes(mirror.box_ray(mirror_ray)), places(input.packed) {}

    Step visit(Mirror& mirror, int place, const typename Mirror::Hit& nearest) {
        const auto node = mirror.bvh_node(place);
        auto first = node.first_planes;
        auto last = node.last_planes;
        if constexpr (requires { mirror.bvh_first_planes(boxes, node); }) {
            first = mirror.bvh_first_planes(boxes, node);
            last = mirror.bvh_last_planes(boxes, node);
        }
        const auto span = mirror.span_in_box(boxes, first, last, t_max);
        Step step;
        step.cell = places.in_first_octant(place);
        step.entry = span.entry;
        step.exit = span.exit;
        if (!mirror.meets_bvh_node(boxes, node, nearest.t)) {
            const bool in_the_way = mirror.meets_bvh_node(boxes, node, t_max);
            step.outcome = in_the_way ? Outcome::behind : Outcome::missed;
        } else if (mirror.is_bvh_leaf(node)) {
            step.outcome = Outcome::leaf;
            step.listed = triangles_from(mirror, node.link);
        } else {
            step.outcome = Outcome::entered;
            step.axis = (-1 - node.link) & 3;
        }
        return step;
    }

    void leave(const Step&) const {}

    Ending ending(const RecordedWalk& walk) const {
        if (walk.steps.empty()) {
            return Ending::no_way_in;
        }
        return ended_at_any_hit(walk) ? Ending::found : Ending::all_seen;
    }

    static int triangles_from(Mirror& mirror, int first) {
        int count = 1;
        while (!mirror.bvh_triangle(first + count - 1).last) {
            ++count;
        }
        return count;
    }

    float t_max;
    typename Mirror::BoxRay boxes;
    OctantPlaces places;
};

template <class Mirror>
WalkRecorder bvh_recorder(const RecorderInput& input) {
    return recorder_of<Mirror, ExplainBox<Mirror>>(input);
}

} // namespace

WalkRecorder record_bvh_skip(const RecorderInput& input) {
    return bvh_recorder<mirror::BvhSkipRecorded<float>>(input);
}

WalkRecorder record_bvh_skip_padded(const RecorderInput& input) {
    return bvh_recorder<mirror::BvhSkipPaddedRecorded<float>>(input);
}

WalkRecorder record_bvh_ordered(const RecorderInput& input) {
    return bvh_recorder<mirror::BvhOrderedRecorded<float>>(input);
}

WalkRecorder record_bvh_parent(const RecorderInput& input) {
    return bvh_recorder<mirror::BvhParentRecorded<float>>(input);
}

WalkRecorder record_bvh_stack(const RecorderInput& input) {
    return bvh_recorder<mirror::BvhStackRecorded<float>>(input);
}

} // namespace raysteps
