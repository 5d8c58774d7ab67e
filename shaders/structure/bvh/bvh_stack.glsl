// A bounding volume hierarchy, walked with a stack, near children first. The stack remembers the
// last 16 far children put off, and forgets those before: so it cannot overflow, however deep the
// tree. When it is empty and something was forgotten, the parents lead to the next node
// (structure/bvh/bvh_climb.glsl), and so they do where a launch goes on, with an empty stack.
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_plain.glsl"
#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_nodes.glsl"
#include "structure/bvh/bvh_choose_planes.glsl"
#include "structure/bvh/bvh_climb.glsl"

const int bvh_stack_size = 16; // a power of two: places in it go round

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    BoxRay for_boxes = box_ray(ray);
    PreparedRay for_triangles = prepare_ray(ray);
    Hit nearest = walk.nearest;
    int node = walk.place.x;
    int triangle = walk.place.y;
    bool done = walk.place.z != 0;
    int put_off[16];
    int top = 0;    // how many were put off and not yet taken up, forgotten ones too
    int filled = 0; // how many of the last ones are still there
    bool forgotten = node != 0;
    int left = rounds;
    while (left > 0 && (node >= 0 || triangle >= 0)) {
        while (left > 0 && node >= 0 && !done && triangle < 0) {
            observe_visit(node);
            BvhNode here = bvh_node(node);
            bool met = meets_bvh_node(for_boxes, here, nearest.t);
            triangle = met ? max(here.link, no_bvh_triangle) : no_bvh_triangle;
            if (met && !is_bvh_leaf(here)) {
                BvhChildren children = bvh_children(for_boxes, node, here.link);
                node = children.near;
                put_off[top & (bvh_stack_size - 1)] = children.far;
                top = top + 1;
                forgotten = forgotten || filled == bvh_stack_size;
                filled = min(filled + 1, bvh_stack_size);
            } else if (filled > 0) {
                top = top - 1;
                filled = filled - 1;
                node = put_off[top & (bvh_stack_size - 1)];
            } else {
                done = forgotten;
                node = forgotten ? node : no_bvh_node;
            }
            --left;
        }
        while (left > 0 && node >= 0 && done && triangle < 0) {
            BvhClimb up = climb_bvh(for_boxes, node);
            node = up.node;
            done = up.left;
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
