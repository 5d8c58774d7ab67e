// The listing with q for the cross product. The test of det is overwritten (slip 5), so nothing is
// culled.
#include "triangle/paper/listing.glsl"

Hit intersect_triangle(PreparedRay prepared, real3 a, real3 b, real3 c, int triangle) {
    PaperTerms terms = paper_terms(prepared.ray, a, b, c);
    bool accepted = paper_accepts(terms, terms.t, prepared.ray);
    return paper_hit(terms, terms.t, accepted, triangle);
}
