// The two questions that a ray tracer asks, over whichever find_hit a structure has.

// The nearest hit of all: nothing is near enough to stop before.
Hit closest_hit(Ray ray) {
    return find_hit(ray, -real(farthest));
}

// Any hit at all: the first one found will do.
Hit any_hit(Ray ray) {
    return find_hit(ray, real(farthest));
}
