// Where a ray meets a triangle (a, b, c): at origin + t * direction, which is
// (1 - u - v) * a + u * b + v * c. For a miss, t is the ray's t_max and the triangle no_triangle.
struct Hit {
    real t;
    real u;
    real v;
    int triangle;
};

const int no_triangle = -1;

// The one rule that makes all structures comparable: the nearest hit wins, and of equal distances
// the smallest triangle. The answer does not depend on the order in which triangles are met.

Hit miss(Ray ray) {
    Hit hit;
    hit.t = ray.t_max;
    hit.u = real(0.0f);
    hit.v = real(0.0f);
    hit.triangle = no_triangle;
    return hit;
}

bool is_hit(Hit hit) {
    return hit.triangle >= 0;
}

bool is_nearer(Hit hit, Hit best) {
    //# exercise 2.4: which of two hits wins
    bool wins_tie = hit.t == best.t && (!is_hit(best) || hit.triangle < best.triangle);
    return is_hit(hit) && (hit.t < best.t || wins_tie);
    //# stub: return false;
    //# end
}
