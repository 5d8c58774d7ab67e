// Which of two hits wins: one at t = origin.x of triangle origin.y, and the best so far, at t =
// direction.x of triangle direction.y. Numbers below zero are no triangles.
//
// From step 2 on, the best one's t is the same, the next one above or the next one below; and the
// steps go through pairs of triangles.

const ivec2 pairs[8] = ivec2[8](ivec2(3, 5), ivec2(5, 3), ivec2(4, 4), ivec2(0, -1), ivec2(0, 5),
                                ivec2(5, 0), ivec2(-1, 3), ivec2(-1, -1));

uvec4 checkpoint(Ray ray, int step) {
    Hit hit;
    hit.t = ray.origin.x;
    hit.u = real(0.25f);
    hit.v = real(0.5f);
    hit.triangle = int(floor(ray.origin.y));
    Hit best = hit;
    best.t = ray.direction.x;
    best.triangle = int(floor(ray.direction.y));
    if (step > 1) {
        ivec2 pair = pairs[(step - 2) / 3];
        int relation = (step - 2) % 3;
        hit.triangle = pair.x;
        best.triangle = pair.y;
        best.t = relation == 0 ? hit.t : relation == 1 ? just_above(hit.t) : just_below(hit.t);
    }
    also = uvec4(bits(best.t), 0u, 0u, 0u);
    return uvec4(is_nearer(hit, best) ? 1u : 0u, uint(hit.triangle), uint(best.triangle),
                 bits(hit.t));
}
