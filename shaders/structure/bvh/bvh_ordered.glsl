// A bounding volume hierarchy, walked without a stack, near branches first: the nodes lie in an
// order of their own for each octant of directions, so a near hit is found early, and what lies
// behind it is skipped. The order is that of the two children's centres along one axis, not that of
// distances along the ray. Skip pointers: Thrane and Simonsen, "A Comparison of Acceleration
// Structures for GPU Assisted Ray Tracing", 2005.
// Otherwise the walk is that of structure/bvh/bvh_skip.glsl.
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_plain.glsl"
#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_nodes.glsl"

int first_bvh_node(BoxRay ray) {
    int octant =
        (descends(ray, 0) ? 1 : 0) + (descends(ray, 1) ? 2 : 0) + (descends(ray, 2) ? 4 : 0);
    return octant * bvh_node_count;
}

bool meets_bvh_node(BoxRay ray, BvhNode node, real t_max) {
    return meets_box(ray, node.first_planes, node.last_planes, t_max);
}

Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.ended = is_empty(ray) || bvh_node_count == 0;
    walk.place = ivec3(first_bvh_node(box_ray(ray)), no_bvh_triangle, 0);
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
