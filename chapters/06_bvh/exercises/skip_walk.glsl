// A whole walk: a hierarchy by skip pointers, without a stack. In a check it takes the place of
// structure/bvh/bvh_skip.glsl.
//
// The contract, beside that of chapter 02 (a launch takes the walk up where the one before has
// left it, makes at most `rounds` rounds, and its end changes nothing):
//
// - place.x is the next node, or no_bvh_node (-1). place.y is the next triangle of a leaf whose
//   box the ray has met, as a place in the list, or no_bvh_triangle (-1). place.z is not used.
// - Where there is a triangle, a round tests it, after observe_test(its number): the triangles of
//   a leaf come before the next node. bvh_triangle(place) has its corners a, b and c, its number,
//   and whether it is the last one of its leaf.
// - Else a round looks at the next node, after observe_visit(place). The ray meets it where
//   meets_bvh_node(for_boxes, node, nearest.t), so what begins behind the best hit is left out. On
//   from a branch that is met to the node behind it in memory, place + 1; from all others to
//   node.skip. A leaf that is met (is_bvh_leaf) has its first triangle in node.link.
// - The walk has ended when neither a node nor a triangle is left; or at once with a hit whose t
//   is at most near_enough. It starts at node 0, and has ended there where the ray is empty or
//   bvh_node_count is 0.
//
// Beside what chapter 02 lists (prepare_ray(), which gives a PreparedRay, intersect_triangle(),
// is_nearer(), miss(), is_empty()), these are at hand, so no other file has to be opened:
//
//     BoxRay box_ray(Ray ray)                    prepares a ray for boxes, once a launch
//     BvhNode bvh_node(int place)                first_planes, last_planes, skip, link
//     bool is_bvh_leaf(BvhNode node)
//     bool meets_bvh_node(BoxRay ray, BvhNode node, real t_max)
//     BvhTriangle bvh_triangle(int place)        a, b, c, number, last
//     BvhLeaf test_bvh_leaf(PreparedRay ray, Hit nearest, int triangle, real near_enough, int left)
//
// The last one tests the triangles of a leaf as the project's walks do: nearest, triangle, left and
// found are the state after it. You may call it, or write that loop yourself. Of a walk that has
// ended, a check shows the place as 0.
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_plain.glsl"
#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_nodes.glsl"
#include "structure/bvh/bvh_choose_planes.glsl"

//# exercise 6.7: a whole walk, by skip pointers
Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.place = ivec3(0, no_bvh_triangle, 0);
    walk.ended = is_empty(ray) || bvh_node_count == 0;
    return walk;
}

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    BoxRay for_boxes = box_ray(ray);
    PreparedRay for_triangles = prepare_ray(ray);
    for (int left = rounds; left > 0 && !walk.ended; --left) {
        if (walk.place.y >= 0) {
            BvhTriangle tested = bvh_triangle(walk.place.y);
            observe_test(tested.number);
            Hit hit =
                intersect_triangle(for_triangles, tested.a, tested.b, tested.c, tested.number);
            walk.place.y = tested.last ? no_bvh_triangle : walk.place.y + 1;
            if (is_nearer(hit, walk.nearest)) {
                walk.nearest = hit;
                walk.ended = hit.t <= near_enough;
            }
        } else {
            observe_visit(walk.place.x);
            BvhNode node = bvh_node(walk.place.x);
            bool met = meets_bvh_node(for_boxes, node, walk.nearest.t);
            if (met && is_bvh_leaf(node)) {
                walk.place.y = node.link;
            }
            walk.place.x = met && !is_bvh_leaf(node) ? walk.place.x + 1 : node.skip;
        }
        walk.ended = walk.ended || (walk.place.x < 0 && walk.place.y < 0);
    }
    return walk;
}
//# stub: Walk start_walk(Ray ray) {
//# stub:     Walk walk;
//# stub:     walk.nearest = miss(ray);
//# stub:     walk.place = ivec3(0, no_bvh_triangle, 0);
//# stub:     walk.ended = true;
//# stub:     return walk;
//# stub: }
//# stub: Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
//# stub:     return walk;
//# stub: }
//# end
