// bvh_skip with a box test that has room for its own rounding, to see what that costs. The boxes
// are padded when they are built, so the hits are the same.
#include "layout/bvh.glsl"
#include "geometry/box_ray.glsl"
#include "geometry/box_padded.glsl"
#include "geometry/bvh_choose_planes.glsl"

int first_bvh_node(BoxRay ray) {
    return 0;
}

#include "geometry/bvh_leaf.glsl"
#include "geometry/bvh_skip_walk.glsl"
