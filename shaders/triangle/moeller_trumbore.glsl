// Where does this ray meet this triangle? Both sides of a triangle count, and no number is taken
// for "almost zero": det = 0 makes u, v and t infinite or NaN, which no comparison
// accepts. Source: Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.

struct PreparedRay {
    Ray ray;
};

PreparedRay prepare_ray(Ray ray) {
    PreparedRay prepared;
    prepared.ray = ray;
    return prepared;
}

Hit intersect_triangle(PreparedRay prepared, real3 a, real3 b, real3 c, int triangle) {
    Ray ray = prepared.ray;
    real3 e1 = b - a;
    real3 e2 = c - a;
    real3 p = cross_product(ray.direction, e2);
    real det = dot_product(p, e1);

    //# exercise 2.2: where the ray meets the plane
    real3 to_origin = ray.origin - a;
    real3 q = cross_product(to_origin, e1);
    precise real u = dot_product(p, to_origin) / det;
    precise real v = dot_product(q, ray.direction) / det;
    precise real t = dot_product(q, e2) / det;
    //# stub: real u = -real(1.0f);
    //# stub: real v = -real(1.0f);
    //# stub: real t = real(0.0f);
    //# end

    //# exercise 2.3: which hits count
    bool inside = u >= real(0.0f) && v >= real(0.0f) && u + v <= real(1.0f);
    bool on_ray = t >= ray.t_min && t <= ray.t_max;
    //# stub: bool inside = false;
    //# stub: bool on_ray = false;
    //# end

    Hit hit;
    hit.t = t;
    hit.u = u;
    hit.v = v;
    hit.triangle = inside && on_ray ? triangle : no_triangle;
    return hit;
}
