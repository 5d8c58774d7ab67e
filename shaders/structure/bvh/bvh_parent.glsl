// A bounding volume hierarchy, walked without a stack, near children first: down as long as the ray
// meets boxes, then up by the parents to the next sibling. One copy of the nodes serves all
// directions. Source: Hapala and others, 2011 (structure/bvh/bvh_climb.glsl).
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_plain.glsl"
#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_nodes.glsl"
#include "structure/bvh/bvh_choose_planes.glsl"
#include "structure/bvh/bvh_climb.glsl"

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    BoxRay for_boxes = box_ray(ray);
    PreparedRay for_triangles = prepare_ray(ray);
    Hit nearest = walk.nearest;
    int node = walk.place.x;
    int triangle = walk.place.y;
    bool done = walk.place.z != 0;
    int left = rounds;
    while (left > 0 && (node >= 0 || triangle >= 0)) {
        while (left > 0 && node >= 0 && triangle < 0) {
            bool inside = false;
            if (!done) {
                observe_visit(node);
                BvhNode here = bvh_node(node);
                bool met = meets_bvh_node(for_boxes, here, nearest.t);
                triangle = met ? max(here.link, no_bvh_triangle) : no_bvh_triangle;
                inside = met && !is_bvh_leaf(here);
                node = inside ? bvh_children(for_boxes, node, here.link).near : node;
            }
            if (!inside) {
                BvhClimb up = climb_bvh(for_boxes, node);
                node = up.node;
                done = up.left;
            }
            --left;
        }
        BvhLeaf leaf = test_bvh_leaf(for_triangles, nearest, triangle, near_enough, left);
        nearest = leaf.nearest;
        triangle = leaf.triangle;
        left = leaf.left;
        node = leaf.found ? no_bvh_node : node;
    }
    walk.nearest = nearest;
    walk.place = ivec3(node, triangle, done ? 1 : 0);
    walk.ended = node < 0 && triangle < 0;
    return walk;
}
