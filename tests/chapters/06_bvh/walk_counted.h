#pragma once

#include "bvh_hits.h"

namespace raysteps {

// The walks with somebody who counts.
template <class Call>
void for_each_counted_walk(const mirror::SceneBuffers& scene, const PackedStructure& tree,
                           const Call& call) {
    using namespace mirror;
    call("bvh_skip", mirror_of<walks::bvh_skip<float, Counter>>(scene, tree));
    call("bvh_ordered", mirror_of<walks::bvh_ordered<float, Counter>>(scene, tree));
    call("bvh_parent", mirror_of<walks::bvh_parent<float, Counter>>(scene, tree));
    call("bvh_stack", mirror_of<walks::bvh_stack<float, Counter>>(scene, tree));
}

} // namespace raysteps
