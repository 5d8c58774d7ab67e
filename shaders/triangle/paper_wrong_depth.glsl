// The listing with only its redeclaration deleted (slip 3): `a` means the vertex again, and t with
// it.
#include "triangle/paper/listing.glsl"

Hit intersect_triangle(PreparedRay prepared, real3 a, real3 b, real3 c, int triangle) {
    PaperTerms terms = paper_terms(prepared.ray, a, b, c);
    bool accepted = paper_accepts(terms, terms.t_from_vertex, prepared.ray);
    return paper_hit(terms, terms.t_from_vertex, accepted, triangle);
}
