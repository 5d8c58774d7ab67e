#pragma once

#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "mirror/walks.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/bvh4.h"
#include "structure/padding.h"
#include "support/scene_of.h"
#include "support/walk_hits.h"

#include <algorithm>
#include <string>
#include <vector>

namespace raysteps {

inline Bvh bvh_for(const Scene& scene, std::span<const Ray> rays, BvhOptions options = {}) {
    options.reach = static_cast<double>(reach_of(rays, scene.corners));
    return build_bvh(scene.corners, options);
}

// Calls with the name and the mirror of each walk over the tree, and over what it collapses to.
template <class Call>
void for_each_walk(const mirror::SceneBuffers& scene, const Bvh& bvh,
                   std::span<const glm::vec3> corners, const Call& call) {
    const PackedStructure tree = pack(bvh, corners);
    const PackedStructure wide = pack(collapse(bvh), corners);
    call("bvh_skip", mirror::mirror_of<mirror::walks::bvh_skip<float>>(scene, tree));
    call("bvh_skip_padded", mirror::mirror_of<mirror::walks::bvh_skip_padded<float>>(scene, tree));
    call("bvh_ordered", mirror::mirror_of<mirror::walks::bvh_ordered<float>>(scene, tree));
    call("bvh_parent", mirror::mirror_of<mirror::walks::bvh_parent<float>>(scene, tree));
    call("bvh_stack", mirror::mirror_of<mirror::walks::bvh_stack<float>>(scene, tree));
    call("bvh4", mirror::mirror_of<mirror::walks::bvh4<float>>(scene, wide));
}

// How the walks' hits agree with those of the loop over every triangle.
struct BvhAgreement {
    std::size_t hits = 0;   // of the loop
    std::string exceptions; // the walks that differ and how often; empty where none does
};

inline BvhAgreement agreement_of(const Scene& scene, const Bvh& bvh, std::span<const Ray> rays,
                                 int rounds = whole_walk) {
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> expected = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    BvhAgreement agreement{count_hits(expected), ""};
    for_each_walk(buffers, bvh, scene.corners, [&](const std::string& name, const auto& mirror) {
        const std::size_t different = count_different(expected, hits_by(mirror, rays, rounds));
        if (different > 0) {
            agreement.exceptions += name + ": " + std::to_string(different) + " ";
        }
    });
    return agreement;
}

} // namespace raysteps
