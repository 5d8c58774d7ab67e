// No structure: the loop over every triangle, which all structures have to agree with, bit for bit.
// place.x is the next triangle.
uniform int triangle_count;

Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.place = ivec3(0);
    walk.ended = is_empty(ray) || triangle_count == 0;
    return walk;
}

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    Hit nearest = walk.nearest;
    bool found = false;
    int i = walk.place.x;
    int end = rounds < triangle_count - i ? i + rounds : triangle_count;
    for (; i < end && !found; ++i) {
        observe_test(i);
        Hit hit = intersect_triangle(prepared, triangle_corner(i, 0), triangle_corner(i, 1),
                                     triangle_corner(i, 2), i);
        if (is_nearer(hit, nearest) && is_solid(hit)) {
            nearest = hit;
            found = hit.t <= near_enough;
        }
    }
    walk.nearest = nearest;
    walk.place.x = i;
    walk.ended = found || i == triangle_count;
    return walk;
}
