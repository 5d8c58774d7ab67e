#include "mirror/walks.h"
#include "record_with.h"

#include <algorithm>

namespace raysteps {

namespace {

// Where the ray leaves a node's box. Not every walk reads the boxes; but the planes are those of
// the splits, so the numbers are those of every walk.
class BoxExits {
public:
    BoxExits(const RecorderInput& input, const Ray& ray)
        : mirror_(mirror::mirror_of<Mirror>(input.scene, input.packed)),
          ray_(mirror::to_mirror<Mirror>(ray)), end_(mirror_.part_in_tree(ray_).exit) {}

    struct Exit {
        float t;
        int face; // -1 where the ray never leaves
    };

    Exit of(int place) const {
        Mirror mirror = mirror_;
        const auto exit = mirror.box_exit(place, ray_);
        return {std::min(exit.t, end_), exit.face};
    }

    // Where the ray leaves the tree, or ends.
    float end() const { return end_; }

private:
    using Mirror = mirror::walks::kd_backtrack<float>;
    mutable Mirror mirror_;
    Mirror::Ray ray_;
    float end_;
};

// A walk goes on at t, which is where the ray left the last leaf. An inner node sends it to the
// child that holds t.
template <class Mirror>
struct ExplainNode {
    static constexpr bool each_test_is_a_step = false;

    ExplainNode(Mirror& mirror, const typename Mirror::Ray& mirror_ray, const RecorderInput& input)
        : ray(mirror_ray), exits(input, {mirror_ray.origin, mirror_ray.direction, mirror_ray.t_min,
                                         mirror_ray.t_max}),
          t(mirror.part_in_tree(mirror_ray).entry),
          nodes(static_cast<int>(input.packed.integer_vectors.at("kd_nodes").size())) {}

    bool knows(const Mirror&, int place) const { return place >= 0 && place < nodes; }

    Step visit(Mirror& mirror, int place, const typename Mirror::Hit&) {
        const auto node = mirror.kd_node(place);
        const auto exit = exits.of(place);
        Step step;
        step.cell = place;
        step.entry = t;
        step.exit = exit.t;
        step.face = exit.face;
        if (node.axis == mirror.kd_leaf) {
            step.listed = node.end_reference - node.first_reference;
            // Ropes lead to leaves that the ray only touches; descents never do.
            const bool only_touched = exit.t <= t && exit.t < exits.end();
            step.outcome = only_touched ? Outcome::touched : Outcome::leaf;
        } else {
            const bool upwards = last_place != no_cell && mirror.kd_parent(last_place) == place;
            step.outcome = upwards ? Outcome::climbed : Outcome::entered;
            step.axis = node.axis;
            step.plane_t = mirror.plane_distance(node.split, ray, node.axis);
        }
        last_place = place;
        return step;
    }

    void leave(const Step& step) {
        if (step.outcome == Outcome::leaf) {
            t = step.exit;
        }
    }

    Ending ending(const RecordedWalk& walk) const {
        if (walk.steps.empty()) {
            return Ending::no_way_in;
        }
        if (ended_at_any_hit(walk)) {
            return Ending::found;
        }
        const Step& last = walk.steps.back();
        if (!(last.nearest.t < last.exit)) {
            return last.exit < walk.ray.t_max ? Ending::outside : Ending::ray_is_over;
        }
        return walk.hit.triangle == no_triangle ? Ending::ray_is_over : Ending::hit;
    }

    typename Mirror::Ray ray;
    BoxExits exits;
    float t; // where the walk is
    int nodes;
    int last_place = no_cell;
};

template <template <class, class> class Walk>
WalkRecorder make_kd_tree(const RecorderInput& input) {
    using Mirror = Walk<float, mirror::Recorder>;
    return recorder_of<Mirror, ExplainNode<Mirror>>(input);
}

} // namespace

Recorders kd_tree_recorders() {
#define WALK(name) {#name, make_kd_tree<mirror::walks::name>},
    return {WALKS_IN_kd_tree};
#undef WALK
}

} // namespace raysteps
