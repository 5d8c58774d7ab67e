// The listing with its test of det in force (slip 6): back faces are gone for every ray, shadow
// rays too.
#include "triangle/paper/listing.glsl"

Hit intersect_triangle(PreparedRay prepared, real3 a, real3 b, real3 c, int triangle) {
    PaperTerms terms = paper_terms(prepared.ray, a, b, c);
    bool accepted = terms.det > real(0.000001f) && paper_accepts(terms, terms.t, prepared.ray);
    return paper_hit(terms, terms.t, accepted, triangle);
}
