// The listing with both sides let through, but still its 1e-6 (slip 7): det is as long as an edge
// times an edge, so the triangles of a small model vanish.
#include "triangle/paper/listing.glsl"

Hit intersect_triangle(PreparedRay prepared, real3 a, real3 b, real3 c, int triangle) {
    PaperTerms terms = paper_terms(prepared.ray, a, b, c);
    bool accepted = abs(terms.det) > real(0.000001f) && paper_accepts(terms, terms.t, prepared.ray);
    return paper_hit(terms, terms.t, accepted, triangle);
}
