// A bounding volume hierarchy, walked with a stack, near children first. The stack remembers the
// last 16 far children put off, and forgets those before: so it cannot overflow, however deep the
// tree. When it is empty and something was forgotten, the parents lead to the next node
// (geometry/bvh_climb.glsl), and so they do where a launch goes on, with an empty stack.
#include "layout/bvh.glsl"
#include "geometry/box_ray.glsl"
#include "geometry/box_plain.glsl"
#include "geometry/bvh_choose_planes.glsl"
#include "geometry/bvh_climb.glsl"

const int bvh_stack_size = 16; // a power of two: places in it go round

// place is that of bvh_parent.
Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.ended = is_empty(ray) || bvh_node_count == 0;
    walk.place = ivec3(0, no_bvh_triangle, 0);
    return walk;
}

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    BoxRay prepared_for_boxes = box_ray(ray);
    PreparedRay prepared = prepare_ray(ray);
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
            bool met = meets_bvh_node(prepared_for_boxes, here, nearest.t);
            triangle = met ? max(here.link, no_bvh_triangle) : no_bvh_triangle;
            if (met && !is_bvh_leaf(here)) {
                BvhChildren children = bvh_children(prepared_for_boxes, node, here.link);
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
            BvhClimb up = climb_bvh(prepared_for_boxes, node);
            node = up.node;
            done = up.left;
            --left;
        }
        while (left > 0 && triangle >= 0) {
            BvhTriangle tested = bvh_triangle(triangle);
            observe_test(tested.number);
            Hit hit = intersect_triangle(prepared, tested.a, tested.b, tested.c, tested.number);
            triangle = tested.last ? no_bvh_triangle : triangle + 1;
            if (is_nearer(hit, nearest)) {
                nearest = hit;
                bool found = hit.t <= near_enough;
                node = found ? no_bvh_node : node;
                triangle = found ? no_bvh_triangle : triangle;
            }
            --left;
        }
    }
    walk.nearest = nearest;
    walk.place = ivec3(node, triangle, done ? 1 : 0);
    walk.ended = node < 0 && triangle < 0;
    return walk;
}
