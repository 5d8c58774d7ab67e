// bvh_skip with a box test that has room for its own rounding, to see what that costs. The boxes
// are padded when they are built, so the hits are the same.
#include "structure/bvh/bvh_nodes.glsl"
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_padded.glsl"
#include "structure/bvh/bvh_choose_planes.glsl"

int first_bvh_node(BoxRay ray) {
    return 0;
}

#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_skip_walk.glsl"
