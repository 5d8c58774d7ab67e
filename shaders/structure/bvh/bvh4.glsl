// A bounding volume hierarchy with up to four children a node, nearest child first. All four boxes
// are met in one step: fewer steps, fewer fetches, and four times the same arithmetic, which a
// processor does side by side.
//
// The order of the children is that of (entry, child): where the ray enters a box, and of equal
// entries, of which there are many where a ray begins, the first child. It depends on the ray and
// the boxes alone, never on the best hit. So a child's number says which of its siblings come after
// it, the way back through the tree can be found from any place, and a launch may stop anywhere.
//
// A stack of eight places saves that way where it can: what is pushed is the node, to be seen once
// more behind the child that is taken, or the last child itself where only one is left. The stack
// forgets its lowest place when a ninth comes. When it is empty and something was forgotten, the
// walk goes on behind what it saw last. Source of the short stack: Laine, "Restart Trail for
// Stackless BVH Traversal", 2010; there, a trail of bits says what a node's entries say here.
//
// place.x is the next place in the tree, place.y the next triangle of a leaf, place.z what was seen
// last. A leaf that was on the stack may be tested a second time on the way back: that changes
// nothing.
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh4_nodes.glsl"

const int bvh4_steps = 8; // through nodes, before triangles are tested

struct Bvh4Stack {
    ivec4 upper; // the top comes first
    ivec4 lower;
    bool forgotten;
};

Bvh4Stack push_bvh4(Bvh4Stack stack, int place) {
    Bvh4Stack pushed;
    pushed.forgotten = stack.forgotten || stack.lower.w != no_bvh4_place;
    pushed.lower = ivec4(stack.upper.w, stack.lower.x, stack.lower.y, stack.lower.z);
    pushed.upper = ivec4(place, stack.upper.x, stack.upper.y, stack.upper.z);
    return pushed;
}

Bvh4Stack pop_bvh4(Bvh4Stack stack) {
    Bvh4Stack popped;
    popped.forgotten = stack.forgotten;
    popped.upper = ivec4(stack.upper.y, stack.upper.z, stack.upper.w, stack.lower.x);
    popped.lower = ivec4(stack.lower.y, stack.lower.z, stack.lower.w, no_bvh4_place);
    return popped;
}

// Where the walk goes on that has seen all there was below this place.
int next_bvh4_place(Bvh4Stack stack, int seen) {
    //# exercise 10.2: the way back
    int back = stack.forgotten ? seen : no_bvh4_place;
    return stack.upper.x != no_bvh4_place ? stack.upper.x : back;
    //# stub: return stack.upper.x;
    //# end
}

// The children that are met and still to be seen.
struct Bvh4Choice {
    int count;
    int child; // the nearest
    int link;  // of it
    int other; // the link of the other one, where there are two
};

Bvh4Choice choose_bvh4_child(BoxRay ray, int place, real t_max) {
    int node = bvh4_node(place);
    ivec4 links = bvh4_links(node);
    Bvh4Spans spans = bvh4_spans(ray, node, t_max);
    int last = bvh4_last_child(place);
    real seen = ray.t_min; // no entry comes before
    for (int child = 0; child < 4; ++child) {
        seen = child == last ? spans.entry[child] : seen;
    }
    Bvh4Choice choice;
    choice.count = 0;
    choice.child = -1;
    choice.link = no_bvh4_place;
    choice.other = no_bvh4_place;
    real least = ray.t_min;
    for (int child = 0; child < 4; ++child) {
        real entry = spans.entry[child];
        //# exercise 10.1: the order of four children
        bool met = entry <= spans.exit[child] && links[child] != no_bvh4_place;
        bool waits = met && (entry > seen || (entry == seen && child > last));
        bool nearer = waits && (choice.count == 0 || entry < least);
        //# stub: bool met = entry <= spans.exit[child] && links[child] != no_bvh4_place;
        //# stub: bool waits = met && child > last;
        //# stub: bool nearer = waits && choice.count == 0;
        //# end
        int behind = waits ? links[child] : choice.other;
        choice.other = nearer ? choice.link : behind;
        choice.link = nearer ? links[child] : choice.link;
        choice.child = nearer ? child : choice.child;
        least = nearer ? entry : least;
        choice.count = waits ? choice.count + 1 : choice.count;
    }
    return choice;
}

Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.ended = is_empty(ray) || bvh_node_count == 0;
    walk.place = ivec3(0, no_bvh_triangle, no_bvh4_place);
    return walk;
}

// Loops are written as `if (...) do ... while (...)`: where rays run side by side under a mask,
// some compilers let a `while` run once more than any ray needs.
Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    BoxRay for_boxes = box_ray(ray);
    PreparedRay for_triangles = prepare_ray(ray);
    Hit nearest = walk.nearest;
    int place = walk.place.x;
    int triangle = walk.place.y;
    int seen = walk.place.z;
    Bvh4Stack stack;
    stack.upper = ivec4(no_bvh4_place);
    stack.lower = ivec4(no_bvh4_place);
    stack.forgotten = seen != no_bvh4_place; // by a launch that has ended
    int left = rounds;
    if (left > 0 && (place != no_bvh4_place || triangle >= 0)) {
        do {
            // Down to a leaf, a few steps at most: rays side by side wait for each other.
            int last_left = max(left - bvh4_steps, 0);
            if (left > last_left && has_bvh4_children(place) && triangle < 0) {
                do {
                    observe_visit(place);
                    int node = bvh4_node(place);
                    Bvh4Choice choice = choose_bvh4_child(for_boxes, place, nearest.t);
                    seen = node + (choice.count > 0 ? choice.child + 1 : bvh4_all_seen);
                    if (choice.count > 1) {
                        stack = push_bvh4(stack, choice.count == 2 ? choice.other : seen);
                    }
                    place = choice.link;
                    if (choice.count == 0) {
                        place = next_bvh4_place(stack, seen);
                        stack = pop_bvh4(stack);
                    }
                    --left;
                } while (left > last_left && has_bvh4_children(place));
            }
            if (left > 0 && is_bvh4_done(place) && triangle < 0) {
                place = bvh4_way_up(bvh4_node(place));
                --left;
            }
            if (left > 0 && is_bvh4_leaf(place) && triangle < 0) {
                observe_visit(place);
                triangle = bvh4_first_triangle(place);
                place = next_bvh4_place(stack, seen);
                stack = pop_bvh4(stack);
                --left;
            }
            if (left > 0 && triangle >= 0) {
                do {
                    BvhTriangle tested = bvh_triangle(triangle);
                    observe_test(tested.number);
                    Hit hit = intersect_triangle(for_triangles, tested.a, tested.b, tested.c,
                                                 tested.number);
                    triangle = tested.last ? no_bvh_triangle : triangle + 1;
                    if (is_nearer(hit, nearest) && is_solid(hit)) {
                        nearest = hit;
                        bool found = hit.t <= near_enough;
                        triangle = found ? no_bvh_triangle : triangle;
                        place = found ? no_bvh4_place : place;
                    }
                    --left;
                } while (left > 0 && triangle >= 0);
            }
        } while (left > 0 && (place != no_bvh4_place || triangle >= 0));
    }
    walk.nearest = nearest;
    walk.place = ivec3(place, triangle, seen);
    walk.ended = place == no_bvh4_place && triangle < 0;
    return walk;
}
