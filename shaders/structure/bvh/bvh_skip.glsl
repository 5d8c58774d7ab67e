// A bounding volume hierarchy, walked without a stack in one order for all rays: each node says
// where to go on when the ray does not meet it. Source: Thrane and Simonsen, "A Comparison of
// Acceleration Structures for GPU Assisted Ray Tracing", 2005.
#include "structure/bvh/bvh_nodes.glsl"
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_plain.glsl"
#include "structure/bvh/bvh_choose_planes.glsl"

int first_bvh_node(BoxRay ray) {
    return 0;
}

#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_skip_walk.glsl"
