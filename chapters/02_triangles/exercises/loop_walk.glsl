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
// - place.x is the next triangle to be tested. place.y and place.z are not used. Once a walk has
//   ended its place means nothing, here and in the chapters to come: a check shows it as 0.
// - ended says that there is nothing left to do: all triangles are tested; or a hit was found
//   whose t is at most near_enough. A ray that is_empty, and a scene without triangles, have
//   nothing to do from the start.
//
// The scene has the triangles 0 to triangle_count - 1. All that a walk needs is at hand:
//
//     real3 triangle_corner(int i, int corner)   corner 0, 1 or 2 of triangle i
//     PreparedRay prepare_ray(Ray ray)           what the triangle tests share, once a launch
//     Hit intersect_triangle(PreparedRay ray, real3 a, real3 b, real3 c, int i)
//     Hit miss(Ray ray)                          no hit yet: its t is the ray's t_max
//     bool is_nearer(Hit hit, Hit best)          whether it is a hit, and wins over the best one
//     bool is_hit(Hit hit), bool is_empty(Ray ray)
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
