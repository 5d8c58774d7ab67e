// Does the ray meet the box at or before t_max? With room for rounding in the test itself: the exit
// moves out by 4 units in the last place. So a box that is not padded is never missed where the ray
// meets it, even if it only touches it (docs/numerics.md, section 6). A hit is another matter: it
// lies beside the ray by the triangle test's own rounding, and only a padded box
// (structure/padding.h) is sure to be around it.
// Source: Ize, "Robust BVH Ray Traversal", 2013; there it is 2 units, which are not quite enough.

const float four_last_places = 4.76837158203125e-7f; // 2^-21

bool meets_box(BoxRay ray, real3 first_planes, real3 last_planes, real t_max) {
    BoxSpan span = span_in_box(ray, first_planes, last_planes, t_max);
    //# exercise 8.1: room for rounding
    precise real room = abs(span.exit) * real(four_last_places);
    precise real exit = span.exit + room;
    return span.entry <= exit;
    //# stub: return span.entry <= span.exit;
    //# end
}
