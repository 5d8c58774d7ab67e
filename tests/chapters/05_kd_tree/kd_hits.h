#pragma once

#include "hard_cases/meshes.h"
#include "hard_cases/aimed_rays.h"
#include "mirror/walks.h"
#include "structure/kd_tree/build_kd_tree.h"
#include "structure/padding.h"
#include "support/gpu_hits.h"
#include "support/walk_hits.h"

#include <algorithm>
#include <string>
#include <vector>

namespace raysteps {

// An observer that writes down what a walk enters and tests.
struct Trail {
    std::vector<int> visited;
    std::vector<int> tested;

    void visit(int place) { visited.push_back(place); }
    void test(int triangle) { tested.push_back(triangle); }
};

using Restart = mirror::walks::kd_restart<float>;
using Backtrack = mirror::walks::kd_backtrack<float>;
using ShortStack = mirror::walks::kd_short_stack<float>;
using RopesWalk = mirror::walks::kd_ropes<float>;

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

// How many hits of each walk are not those of the loop over every triangle.
struct KdAgreement {
    std::size_t hits = 0; // of the loop
    std::size_t restart = 0;
    std::size_t backtrack = 0;
    std::size_t short_stack = 0;
    std::size_t ropes = 0;
};

inline bool agrees(const KdAgreement& agreement) {
    return agreement.restart + agreement.backtrack + agreement.short_stack + agreement.ropes == 0;
}

inline std::string to_text(const KdAgreement& agreement) {
    return "different hits: restart " + std::to_string(agreement.restart) + ", backtrack " +
           std::to_string(agreement.backtrack) + ", short stack " +
           std::to_string(agreement.short_stack) + ", ropes " + std::to_string(agreement.ropes) +
           " of " + std::to_string(agreement.hits) + " hits";
}

inline KdAgreement agreement_of(const Scene& scene, const KdTree& tree, std::span<const Ray> rays,
                              int rounds = whole_walk) {
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(tree);
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
