#include "mirror_methods.h"

#include "mirror/bvh.h"
#include "mirror/every_triangle.h"
#include "mirror/grid.h"
#include "mirror/half_bvh.h"
#include "mirror/kd_tree.h"
#include "mirror/packed_mirror.h"
#include "mirror/triangle_tests.h"
#include "basics/threads.h"

namespace raysteps {

namespace {

constexpr std::size_t rays_a_part = 1024;
constexpr int most_rounds = 1 << 26; // more than any walk here needs

template <class Mirror>
Hit hit_of(Mirror& mirror, const Ray& ray) {
    const auto own = mirror::to_mirror<Mirror>(ray);
    auto walk = mirror.start_walk(own);
    if (!walk.ended) {
        walk = mirror.go_on(walk, own, -mirror.farthest, most_rounds);
    }
    Hit hit = mirror::from_mirror(walk.nearest);
    hit.triangle = walk.ended ? hit.triangle : no_answer;
    return hit;
}

template <class Mirror>
std::vector<Hit> trace(const mirror::SceneBuffers& scene, const PackedStructure& structure,
                       std::span<const Ray> rays) {
    const auto shared = mirror::mirror_of<Mirror>(scene, structure);
    std::vector<Hit> hits(rays.size());
    in_parts(all_cores, rays.size(), rays_a_part, [&](std::size_t begin, std::size_t end) {
        Mirror own = shared;
        for (std::size_t i = begin; i < end; ++i) {
            hits[i] = hit_of(own, rays[i]);
        }
    });
    return hits;
}

template <class Mirror>
bool meets(const Ray& ray, const Box& box) {
    Mirror mirror{};
    typename Mirror::BvhNode node{};
    node.first_planes = box.lower;
    node.last_planes = box.upper;
    return mirror.meets_bvh_node(mirror.box_ray(mirror::to_mirror<Mirror>(ray)), node, ray.t_max);
}

} // namespace

const std::map<std::string, TraceByMirror>& mirror_walks() {
    using namespace mirror;
    static const std::map<std::string, TraceByMirror> walks{
        {"every_triangle", trace<EveryTriangleWatertight<float>>},
        {"grid", trace<GridWatertight<float>>},
        {"grid_mailbox", trace<GridMailboxWatertight<float>>},
        {"kd_restart", trace<KdRestart<float>>},
        {"kd_backtrack", trace<KdBacktrack<float>>},
        {"kd_short_stack", trace<KdShortStack<float>>},
        {"kd_ropes", trace<KdRopesWalk<float>>},
        {"bvh_skip", trace<BvhSkip<float>>},
        {"bvh_skip_padded", trace<BvhSkipPadded<float>>},
        {"bvh_ordered", trace<BvhOrdered<float>>},
        {"bvh_parent", trace<BvhParent<float>>},
        {"bvh_stack", trace<BvhStack<float>>},
        {"half_bvh", trace<HalfBvh<float>>},
    };
    return walks;
}

const std::map<std::string, TraceByMirror>& mirror_triangle_tests() {
    using namespace mirror;
    static const std::map<std::string, TraceByMirror> tests{
        {"watertight", trace<EveryTriangleWatertight<float>>},
        {"watertight_rounded", trace<EveryTriangleRounded<float>>},
        {"watertight_double", trace<EveryTriangleWatertight<double>>},
        {"moeller_trumbore", trace<EveryTriangleMoellerTrumbore<float>>},
        {"moeller_trumbore_double", trace<EveryTriangleMoellerTrumbore<double>>},
        {"paper_repaired", trace<EveryTrianglePaperRepaired<float>>},
        {"paper_culling", trace<EveryTrianglePaperCulling<float>>},
        {"paper_two_sided", trace<EveryTrianglePaperTwoSided<float>>},
        {"paper_wrong_depth", trace<EveryTrianglePaperWrongDepth<float>>},
    };
    return tests;
}

bool meets_plain_box(const Ray& ray, const Box& box) {
    return meets<mirror::BvhSkip<float>>(ray, box);
}

bool meets_padded_box(const Ray& ray, const Box& box) {
    return meets<mirror::BvhSkipPadded<float>>(ray, box);
}

Box grown_by_roundings(const Box& box) {
    const float reach = 4.0f;
    const float room = 9.0f * 0x1p-24f * reach;
    return {box.lower - room, box.upper + room};
}

} // namespace raysteps
