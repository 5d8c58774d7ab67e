#pragma once

#include "bvh_hits.h"

// The walks with somebody who counts.
namespace raysteps::mirror {

template <class Real>
struct BvhSkipCounted {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_skip.glsl"
#define OBSERVER_PART "observer/count.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhOrderedCounted {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_ordered.glsl"
#define OBSERVER_PART "observer/count.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhParentCounted {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_parent.glsl"
#define OBSERVER_PART "observer/count.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhStackCounted {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_stack.glsl"
#define OBSERVER_PART "observer/count.glsl"
#include "mirror/parts.inc"
};

} // namespace raysteps::mirror

namespace raysteps {

template <class Call>
void for_each_counted_walk(const mirror::SceneBuffers& scene, const mirror::BvhBuffers& tree,
                           const Call& call) {
    call("bvh_skip", mirror::mirror_of<mirror::BvhSkipCounted<float>>(scene, tree));
    call("bvh_ordered", mirror::mirror_of<mirror::BvhOrderedCounted<float>>(scene, tree));
    call("bvh_parent", mirror::mirror_of<mirror::BvhParentCounted<float>>(scene, tree));
    call("bvh_stack", mirror::mirror_of<mirror::BvhStackCounted<float>>(scene, tree));
}

} // namespace raysteps
