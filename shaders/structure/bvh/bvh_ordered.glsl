// A bounding volume hierarchy, walked without a stack, near branches first: the nodes lie in an
// order of their own for each octant of directions, so a near hit is found early, and what lies
// behind it is skipped. The order is that of the two children's centres along one axis, not that of
// distances along the ray. Skip pointers: Thrane and Simonsen, "A Comparison of Acceleration
// Structures for GPU Assisted Ray Tracing", 2005.
#include "structure/bvh/bvh_nodes.glsl"
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_plain.glsl"

int first_bvh_node(BoxRay ray) {
    int octant =
        (descends(ray, 0) ? 1 : 0) + (descends(ray, 1) ? 2 : 0) + (descends(ray, 2) ? 4 : 0);
    return octant * bvh_node_count;
}

bool meets_bvh_node(BoxRay ray, BvhNode node, real t_max) {
    return meets_box(ray, node.first_planes, node.last_planes, t_max);
}

#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_skip_walk.glsl"
