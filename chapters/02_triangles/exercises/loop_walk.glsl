// A whole walk: the loop over every triangle. In a check it takes the place of
// structure/every_triangle.glsl.
//
// The contract of a walk, here and in the chapters to come (shaders/core/walk.glsl has its
// struct): a platform may cut a loop anywhere, so a walk goes in launches. start_walk says where
// it begins. go_on takes it up where the launch before has left it, makes at most `rounds` rounds,
// and says how far it has come; so it changes nothing where the cuts are.
//
// - A round tests one triangle, and calls observe_test(its number) before.
// - nearest is the best hit so far, by is_nearer; before the first one, miss(ray).
// - place.x is the next triangle to be tested. place.y and place.z are not used.
// - ended says that there is nothing left to do: all triangles are tested; or a hit was found
//   whose t is at most near_enough. A ray that is_empty, and a scene without triangles, have
//   nothing to do from the start.
//
// The scene has the triangles 0 to triangle_count - 1; triangle_corner(i, 0), (i, 1) and (i, 2)
// are the corners of triangle i. prepare_ray(ray) is asked once a launch, and
// intersect_triangle(prepared, a, b, c, i) for each triangle.
uniform int triangle_count;

//# exercise 2.6: a whole walk, the loop over every triangle
Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.place = ivec3(0);
    walk.ended = is_empty(ray) || triangle_count < 1;
    return walk;
}

Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    PreparedRay prepared = prepare_ray(ray);
    int left = rounds;
    while (left > 0 && !walk.ended) {
        int i = walk.place.x;
        observe_test(i);
        Hit hit = intersect_triangle(prepared, triangle_corner(i, 0), triangle_corner(i, 1),
                                     triangle_corner(i, 2), i);
        bool better = is_nearer(hit, walk.nearest);
        if (better) {
            walk.nearest = hit;
        }
        walk.place.x = i + 1;
        walk.ended = (better && hit.t <= near_enough) || i + 1 == triangle_count;
        left = left - 1;
    }
    return walk;
}
//# stub: Walk start_walk(Ray ray) {
//# stub:     Walk walk;
//# stub:     walk.nearest = miss(ray);
//# stub:     walk.place = ivec3(0);
//# stub:     walk.ended = true;
//# stub:     return walk;
//# stub: }
//# stub: Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
//# stub:     return walk;
//# stub: }
//# end
