// No structure: the loop over every triangle, which all structures have to agree with, bit for bit.
// One launch tests the triangles [first_triangle, end_triangle), since some platforms stop a long
// loop silently. The host sees to the rest.
uniform int first_triangle;
uniform int end_triangle;

Hit find_hit(Ray ray, real near_enough) {
    PreparedRay prepared = prepare_ray(ray);
    Hit nearest = miss(ray);
    bool stopped = false;
    int i = first_triangle;
    for (; i < end_triangle && !stopped; ++i) {
        observe_test(i);
        Hit hit = intersect_triangle(prepared, triangle_corner(i, 0), triangle_corner(i, 1),
                                     triangle_corner(i, 2), i);
        if (is_nearer(hit, nearest)) {
            nearest = hit;
            stopped = hit.t <= near_enough;
        }
    }
    if (i < end_triangle && !stopped) {
        nearest.triangle = unfinished_walk;
    }
    return nearest;
}
