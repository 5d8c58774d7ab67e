#pragma once

#include "bvh_hits.h"

namespace raysteps {

// The walks with somebody who counts.
template <class Call>
void for_each_counted_walk(const mirror::SceneBuffers& scene, const Bvh& bvh,
                           std::span<const glm::vec3> corners, const Call& call) {
    using namespace mirror;
    const PackedStructure tree = pack(bvh, corners);
    const PackedStructure wide = pack(collapse(bvh), corners);
    call("bvh_skip", mirror_of<walks::bvh_skip<float, Counter>>(scene, tree));
    call("bvh_ordered", mirror_of<walks::bvh_ordered<float, Counter>>(scene, tree));
    call("bvh_parent", mirror_of<walks::bvh_parent<float, Counter>>(scene, tree));
    call("bvh_stack", mirror_of<walks::bvh_stack<float, Counter>>(scene, tree));
    call("bvh4", mirror_of<walks::bvh4<float, Counter>>(scene, wide));
}

} // namespace raysteps
