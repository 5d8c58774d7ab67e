// bvh_skip with a box test that has room for its own rounding, to see what that costs. The boxes
// are padded when they are built, so the hits are the same.
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_padded.glsl"
#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_nodes.glsl"
#include "structure/bvh/bvh_choose_planes.glsl"

Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.ended = is_empty(ray) || bvh_node_count == 0;
    walk.place = ivec3(0, no_bvh_triangle, 0);
    return walk;
}

// While there are nodes, on to the next leaf, then through its triangles: rays that a processor
// runs side by side then wait for each other in two short loops, rather than at each node.
Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    BoxRay for_boxes = box_ray(ray);
    PreparedRay for_triangles = prepare_ray(ray);
    Hit nearest = walk.nearest;
    int node = walk.place.x;
    int triangle = walk.place.y;
    int left = rounds;
    while (left > 0 && (node >= 0 || triangle >= 0)) {
        while (left > 0 && node >= 0 && triangle < 0) {
            observe_visit(node);
            BvhNode here = bvh_node(node);
            bool met = meets_bvh_node(for_boxes, here, nearest.t);
            triangle = met ? max(here.link, no_bvh_triangle) : no_bvh_triangle;
            node = met && !is_bvh_leaf(here) ? node + 1 : here.skip;
            --left;
        }
        BvhLeaf leaf = test_bvh_leaf(for_triangles, nearest, triangle, near_enough, left);
        nearest = leaf.nearest;
        triangle = leaf.triangle;
        left = leaf.left;
        node = leaf.found ? no_bvh_node : node;
    }
    walk.nearest = nearest;
    walk.place = ivec3(node, triangle, 0);
    walk.ended = node < 0 && triangle < 0;
    return walk;
}
