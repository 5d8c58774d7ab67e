#pragma once

#include "mirror/every_triangle.h"
#include "mirror/kd_tree.h"
#include "structure/build_kd_tree.h"
#include "structure/reach.h"
#include "support/gpu_hits.h"
#include "support/ray_families.h"
#include "support/same_bits.h"

#include <algorithm>
#include <string>
#include <vector>

namespace raysteps {

using EveryTriangle = mirror::EveryTriangleWatertight<float>;
using Restart = mirror::KdRestart<float>;
using Backtrack = mirror::KdBacktrack<float>;
using ShortStack = mirror::KdShortStack<float>;
using RopesWalk = mirror::KdRopesWalk<float>;

inline KdTree tree_for(const Scene& scene, std::span<const Ray> rays, KdOptions options = {}) {
    options.reach = reach_of(rays, scene.corners);
    return build_kd_tree(scene.corners, options);
}

inline KdOptions with_median() {
    KdOptions options;
    options.split = KdSplit::median;
    return options;
}

// As many leaves as can be.
inline KdOptions with_small_leaves() {
    KdOptions options;
    options.leaf_triangles = 0;
    options.traversal_cost = 0.0;
    options.bad_splits = 4;
    return options;
}

// The hits of a mirror whose walks are cut into so many rounds.
template <class Mirror>
std::vector<Hit> hits_by(Mirror mirror, std::span<const Ray> rays, int rounds = 1 << 30) {
    std::vector<Hit> hits;
    for (const Ray& ray : rays) {
        const auto own = mirror::to_mirror<Mirror>(ray);
        auto walk = mirror.start_walk(own);
        while (!walk.ended) {
            walk = mirror.go_on(walk, own, -mirror.farthest, rounds);
        }
        hits.push_back(mirror::from_mirror(walk.nearest));
    }
    return hits;
}

inline std::size_t count_different(std::span<const Hit> a, std::span<const Hit> b) {
    std::size_t different = a.size() == b.size() ? 0 : a.size() + b.size();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        different += same_bits(a[i], b[i]) ? 0 : 1;
    }
    return different;
}

inline std::size_t count_hits(std::span<const Hit> hits) {
    return static_cast<std::size_t>(std::count_if(
        hits.begin(), hits.end(), [](const Hit& hit) { return hit.triangle != no_triangle; }));
}

// How many hits of each walk are not those of the loop over every triangle.
struct Agreement {
    std::size_t hits = 0; // of the loop
    std::size_t restart = 0;
    std::size_t backtrack = 0;
    std::size_t short_stack = 0;
    std::size_t ropes = 0;
};

inline bool agrees(const Agreement& agreement) {
    return agreement.restart + agreement.backtrack + agreement.short_stack + agreement.ropes == 0;
}

inline std::string to_text(const Agreement& agreement) {
    return "different hits: restart " + std::to_string(agreement.restart) + ", backtrack " +
           std::to_string(agreement.backtrack) + ", short stack " +
           std::to_string(agreement.short_stack) + ", ropes " + std::to_string(agreement.ropes) +
           " of " + std::to_string(agreement.hits) + " hits";
}

inline Agreement agreement_of(const Scene& scene, const KdTree& tree, std::span<const Ray> rays,
                              int rounds = 1 << 30) {
    const mirror::SceneBuffers buffers(scene);
    const mirror::KdBuffers packed(tree);
    const std::vector<Hit> expected = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    const auto different = [&](const auto& mirror) {
        return count_different(expected, hits_by(mirror, rays, rounds));
    };
    return {count_hits(expected), different(mirror::mirror_of<Restart>(buffers, packed)),
            different(mirror::mirror_of<Backtrack>(buffers, packed)),
            different(mirror::mirror_of<ShortStack>(buffers, packed)),
            different(mirror::mirror_of<RopesWalk>(buffers, packed))};
}

} // namespace raysteps
