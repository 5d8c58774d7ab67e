// Where does this ray meet this triangle? By scalar triple products: the ray passes an edge on the
// side that the sign of a volume tells, and a triangle is hit where all three signs agree. Seen
// from its other side an edge gives the same number with the other sign, bit for bit, so no ray
// slips between two triangles that share one. Where several edges meet in a corner, the volumes are
// rounded by themselves, and one ray in some hundreds of those aimed at it does slip through.
// Source: Plücker's coordinates in the form of Shoemake, "Plücker coordinate tutorial", 1998;
// computed from the origin, with sums and differences of corners, as in Wald, Woop, Benthin,
// Johnson and Ernst, "Embree: A Kernel Framework for Efficient CPU Ray Tracing", 2014.

struct PreparedRay {
    Ray ray;
};

PreparedRay prepare_ray(Ray ray) {
    PreparedRay prepared;
    prepared.ray = ray;
    return prepared;
}

// Eight times the volume between the direction and the edge, as seen from the origin.
real edge_volume(real3 from, real3 to, real3 direction) {
    return dot_product(cross_product(from + to, from - to), direction);
}

Hit intersect_triangle(PreparedRay prepared, real3 a, real3 b, real3 c, int triangle) {
    Ray ray = prepared.ray;
    real zero = real(0.0f);
    real3 p = a - ray.origin;
    real3 q = b - ray.origin;
    real3 r = c - ray.origin;
    //# exercise 8.3: three volumes of one sign
    real share_a = edge_volume(r, q, ray.direction);
    real share_b = edge_volume(p, r, ray.direction);
    real share_c = edge_volume(q, p, ray.direction);
    precise real sum = share_a + share_b + share_c;
    bool none_negative = share_a >= zero && share_b >= zero && share_c >= zero;
    bool none_positive = share_a <= zero && share_b <= zero && share_c <= zero;
    //# stub: real share_b = zero;
    //# stub: real share_c = zero;
    //# stub: real sum = zero;
    //# stub: bool none_negative = false;
    //# stub: bool none_positive = false;
    //# end

    real3 normal = cross_product(q - p, r - p);
    precise real u = share_b / sum;
    precise real v = share_c / sum;
    precise real t = dot_product(p, normal) / dot_product(ray.direction, normal);
    bool on_ray = t >= ray.t_min && t <= ray.t_max;

    Hit hit;
    hit.t = t;
    hit.u = u;
    hit.v = v;
    hit.triangle =
        (none_negative || none_positive) && sum != zero && on_ray ? triangle : no_triangle;
    return hit;
}
