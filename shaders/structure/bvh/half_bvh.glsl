// A bounding volume hierarchy with boxes of half precision, rounded outwards: half the memory a
// node, larger boxes, and the same hits. Walked as bvh_skip is. Source of the idea: Mahovsky and
// Wyvill, "Memory-Conserving Bounding Volume Hierarchies with Coherent Raytracing", 2006.
#include "structure/bvh/half_bvh_nodes.glsl"
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_plain.glsl"
#include "structure/bvh/bvh_choose_planes.glsl"

int first_bvh_node(BoxRay ray) {
    return 0;
}

#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_skip_walk.glsl"
