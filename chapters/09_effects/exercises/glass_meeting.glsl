// How a direction meets glass of the index 1.5: in step 1 from the air, in step 2 from within. In
// step 3 it goes from water into glass, in step 4 from glass into water, in step 5 out of diamond,
// and in step 6 into it.

struct Indices {
    real before;
    real behind;
};

Indices indices_of(int step) {
    real thin = real(step == 3 || step == 4 ? 1.33f : 1.0f);
    real dense = real(step < 5 ? 1.5f : 2.42f);
    bool inwards = step == 1 || step == 3 || step == 6;
    Indices indices;
    indices.before = inwards ? thin : dense;
    indices.behind = inwards ? dense : thin;
    return indices;
}

// Of the angle between the ray's origin and its direction, 0 to 1: the side does not count.
real cosine_of(Ray ray) {
    return min(abs(dot_product(unit(ray.origin), unit(ray.direction))), real(1.0f));
}
