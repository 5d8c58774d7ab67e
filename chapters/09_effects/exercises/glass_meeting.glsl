// How a direction meets glass of the index 1.5: in step 1 from the air, in step 2 from within.

struct Indices {
    real before;
    real behind;
};

Indices indices_of(int step) {
    Indices indices;
    indices.before = step == 1 ? real(1.0f) : real(1.5f);
    indices.behind = step == 1 ? real(1.5f) : real(1.0f);
    return indices;
}

// Of the angle between the ray's origin and its direction, 0 to 1: the side does not count.
real cosine_of(Ray ray) {
    return min(abs(dot_product(unit(ray.origin), unit(ray.direction))), real(1.0f));
}
