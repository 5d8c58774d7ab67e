#include "record_with.h"

#include <unordered_map>

namespace raysteps {

namespace {

// A node of a BVH lies once in each octant's order (shaders/structure/bvh/bvh_nodes.glsl). This
// finds its place in octant 0, at once for places asked in the order in which a walk comes to them:
// parents first.
class OctantPlaces {
public:
    // Must not outlive the structure.
    explicit OctantPlaces(const PackedStructure& packed);

    bool knows(int place) const;
    int in_first_octant(int place);

private:
    const PackedStructure& packed_;
    int count_;
    std::unordered_map<int, int> known_;
};

OctantPlaces::OctantPlaces(const PackedStructure& packed)
    : packed_(packed), count_(packed.numbers.at("bvh_node_count")) {}

bool OctantPlaces::knows(int place) const {
    const auto nodes = packed_.integer_vectors.find("bvh_nodes");
    const std::size_t places = nodes == packed_.integer_vectors.end()
                                   ? static_cast<std::size_t>(count_) // one octant, as in half_bvh
                                   : nodes->second.size() / 2;
    return place >= 0 && static_cast<std::size_t>(place) < places;
}

// An inner node makes its children known: the near one lies behind it, the far one is its second.
int OctantPlaces::in_first_octant(int place) {
    const int octant = place / count_;
    if (octant == 0) {
        return place;
    }
    const int root = octant * count_;
    if (place != root && !known_.contains(place)) { // a walk that was told may leave parents out
        for (int before = root; before < place; ++before) {
            in_first_octant(before);
        }
    }
    const int here = place == root ? 0 : known_.at(place);
    const std::vector<glm::ivec4>& nodes = packed_.integer_vectors.at("bvh_nodes");
    const int link = nodes[2 * static_cast<std::size_t>(place) + 1].w;
    if (link < 0) {
        const int first_link = nodes[2 * static_cast<std::size_t>(here) + 1].w;
        const int lower = here + 1;
        const int upper = (-1 - first_link) >> 2;
        const bool descends = (octant >> ((-1 - link) & 3) & 1) != 0;
        known_[place + 1] = descends ? upper : lower;
        known_[(-1 - link) >> 2] = descends ? lower : upper;
    }
    return here;
}

Ending box_ending(const RecordedWalk& walk) {
    if (walk.steps.empty()) {
        return Ending::no_way_in;
    }
    return ended_at_any_hit(walk) ? Ending::found : Ending::all_seen;
}

// A box is entered where the ray meets it, and before the best hit so far.
template <class Mirror>
struct ExplainBox {
    static constexpr bool each_test_is_a_step = false;

    ExplainBox(Mirror& mirror, const typename Mirror::Ray& mirror_ray, const RecorderInput& input)
        : t_max(mirror_ray.t_max), boxes(mirror.box_ray(mirror_ray)), places(input.packed) {}

    bool knows(const Mirror&, int place) const { return places.knows(place); }

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

    Ending ending(const RecordedWalk& walk) const { return box_ending(walk); }

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

// A node of four is entered where a box of its children is met. A walk comes back to it for those
// that it has not seen, and may find that they begin behind the best hit now.
template <class Mirror>
struct ExplainFourBoxes {
    static constexpr bool each_test_is_a_step = false;

    ExplainFourBoxes(Mirror& mirror, const typename Mirror::Ray& mirror_ray,
                     const RecorderInput& input)
        : t_max(mirror_ray.t_max), boxes(mirror.box_ray(mirror_ray)) {
        for (const Bvh4Child& child : bvh4_children_of(input.packed)) {
            if (child.parent == root.cell) {
                root.box = merge(root.box, child.box);
            }
            known[child.link] = child;
        }
    }

    bool knows(Mirror& mirror, int place) const {
        const int link = mirror.is_bvh4_leaf(place) ? place : mirror.bvh4_node(place);
        return link == 0 || known.contains(link);
    }

    Step visit(Mirror& mirror, int place, const typename Mirror::Hit& nearest) const {
        const bool leaf = mirror.is_bvh4_leaf(place);
        const int link = leaf ? place : mirror.bvh4_node(place);
        const Bvh4Child here = link == 0 ? root : known.at(link);
        auto first = here.box.lower;
        auto last = here.box.upper;
        for (int axis = 0; axis < 3; ++axis) {
            if (mirror.descends(boxes, axis)) {
                std::swap(first[axis], last[axis]);
            }
        }
        const auto span = mirror.span_in_box(boxes, first, last, t_max);
        Step step;
        step.cell = here.cell;
        step.entry = span.entry;
        step.exit = span.exit;
        if (leaf) {
            step.outcome = Outcome::leaf;
            step.listed = here.triangles;
        } else if (!(span.entry <= span.exit)) {
            step.outcome = Outcome::missed;
        } else if (span.entry > nearest.t) {
            step.outcome = Outcome::behind;
        } else if (mirror.bvh4_last_child(place) >= 0) {
            step.outcome = Outcome::climbed;
        } else {
            const bool met = mirror.choose_bvh4_child(boxes, place, nearest.t).count > 0;
            step.outcome = met ? Outcome::entered : Outcome::emptied;
        }
        return step;
    }

    void leave(const Step&) const {}

    Ending ending(const RecordedWalk& walk) const { return box_ending(walk); }

    float t_max;
    typename Mirror::BoxRay boxes;
    Bvh4Child root{.box = {}, .cell = 0};     // which no link leads to
    std::unordered_map<int, Bvh4Child> known; // by their links
};

template <template <class, class> class Walk>
WalkRecorder make_bvh(const RecorderInput& input) {
    using Mirror = Walk<float, mirror::Recorder>;
    if constexpr (requires(Mirror mirror) { mirror.bvh4_nodes; }) {
        return recorder_of<Mirror, ExplainFourBoxes<Mirror>>(input);
    } else {
        return recorder_of<Mirror, ExplainBox<Mirror>>(input);
    }
}

} // namespace

Recorders bvh_recorders() {
#define WALK(name) {#name, make_bvh<mirror::walks::name>},
    return {WALKS_IN_bvh};
#undef WALK
}

} // namespace raysteps
