// The two questions that a ray tracer asks, over whichever structure there is. A GPU asks them in
// launches (pass/trace/trace.frag); this is the whole walk at once.

Hit find_hit(Ray ray, real near_enough) {
    Walk walk = start_walk(ray);
    while (!walk.ended) {
        walk = go_on(walk, ray, near_enough, 1 << 30);
    }
    return walk.nearest;
}

// The nearest hit of all: nothing is near enough to stop before.
Hit closest_hit(Ray ray) {
    return find_hit(ray, -real(farthest));
}

// Any hit at all: the first one found will do.
Hit any_hit(Ray ray) {
    return find_hit(ray, real(farthest));
}
