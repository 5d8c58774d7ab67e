// Does the ray meet the box at or before t_max? With room for rounding in the test itself: the exit
// moves out by 2 units in the last place. A box that is not padded, which the ray truly meets, is
// then missed only where the ray is in it for no more than 3 roundings of t, and that is very rare
// (docs/numerics.md, section 6). A hit is another matter: it lies beside the ray by the triangle
// test's own rounding, and only a padded box (structure/padding.h) is sure to be around it.
// Source: Ize, "Robust BVH Ray Traversal", 2013.

const float two_last_places = 2.384185791015625e-7f; // 2^-22

bool meets_box(BoxRay ray, real3 first_planes, real3 last_planes, real t_max) {
    BoxSpan span = span_in_box(ray, first_planes, last_planes, t_max);
    //# exercise 8.1: room for rounding
    precise real room = abs(span.exit) * real(two_last_places);
    precise real exit = span.exit + room;
    return span.entry <= exit;
    //# stub: return span.entry <= span.exit;
    //# end
}
