// What the paper's listing computes, once its cross product has a name of its own and minT is a
// number (slips 1, 2 and 4). What it decides from these terms is in triangle_paper_*.glsl. Source:
// Wang and Wen, "Research of Acceleration Structures for GPU Based Ray Tracing", 2010, section 2.2.

struct PreparedRay {
    Ray ray;
};

PreparedRay prepare_ray(Ray ray) {
    PreparedRay prepared;
    prepared.ray = ray;
    return prepared;
}

struct PaperTerms {
    real det;
    real u;
    real v;
    real t;
    real t_from_vertex; // what the listing computes when only the redeclaration is deleted (slip 3)
};

PaperTerms paper_terms(Ray ray, real3 a, real3 b, real3 c) {
    real3 e1 = b - a;
    real3 e2 = c - a;
    real3 p = cross_product(ray.direction, e2);
    real det = dot_product(p, e1);
    precise real inverse_det = real(1.0f) / det;
    real3 to_origin = ray.origin - a;
    real3 q = cross_product(to_origin, e1);
    precise real u = dot_product(p, to_origin) * inverse_det;
    precise real v = dot_product(q, ray.direction) * inverse_det;
    precise real t = dot_product(q, e2) * inverse_det;
    precise real t_from_vertex = dot_product(a, e2) * inverse_det;
    PaperTerms terms;
    terms.det = det;
    terms.u = u;
    terms.v = v;
    terms.t = t;
    terms.t_from_vertex = t_from_vertex;
    return terms;
}

// The listing's decision, for a t of one's choice.
bool paper_accepts(PaperTerms terms, real t, Ray ray) {
    return terms.u >= real(0.0f) && terms.v >= real(0.0f) && terms.u + terms.v <= real(1.0f) &&
           t < ray.t_max && t > ray.t_min;
}

Hit paper_hit(PaperTerms terms, real t, bool accepted, int triangle) {
    Hit hit;
    hit.t = t;
    hit.u = terms.u;
    hit.v = terms.v;
    hit.triangle = accepted ? triangle : no_triangle;
    return hit;
}
