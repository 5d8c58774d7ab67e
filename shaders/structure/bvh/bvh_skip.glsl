// A bounding volume hierarchy, walked without a stack in one order for all rays: each node says
// where to go on when the ray does not meet it. Source: Thrane and Simonsen, "A Comparison of
// Acceleration Structures for GPU Assisted Ray Tracing", 2005.
#include "layout/bvh.glsl"
#include "geometry/box_ray.glsl"
#include "geometry/box_plain.glsl"
#include "geometry/bvh_choose_planes.glsl"

int first_bvh_node(BoxRay ray) {
    return 0;
}

#include "geometry/bvh_leaf.glsl"
#include "geometry/bvh_skip_walk.glsl"
