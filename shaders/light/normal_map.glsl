// Normal maps: a picture whose red, green and blue are the parts of a normal along the texture's
// u, along its v and upright, each from -1 to 1. Source: Peercy, Airey and Cabral, "Efficient Bump
// Mapping Hardware", 1997.

// Along u and along v on the triangle; zero where its corners have no area in the texture.
struct Tangents {
    real3 along_u;
    real3 along_v;
};

Tangents tangents_of(int triangle) {
    real3 a = triangle_corner(triangle, 0);
    real3 to_b = triangle_corner(triangle, 1) - a;
    real3 to_c = triangle_corner(triangle, 2) - a;
    real3 place_a = triangle_coordinate(triangle, 0);
    real3 place_b = triangle_coordinate(triangle, 1) - place_a;
    real3 place_c = triangle_coordinate(triangle, 2) - place_a;
    real area = place_b.x * place_c.y - place_b.y * place_c.x;
    real turn = area > real(0.0f) ? real(1.0f) : area < real(0.0f) ? -real(1.0f) : real(0.0f);
    Tangents tangents;
    tangents.along_u = turn * (place_c.y * to_b - place_b.y * to_c);
    tangents.along_v = turn * (place_b.x * to_c - place_c.x * to_b);
    return tangents;
}

// The surface's normal, bent by the colour of its picture. The surface may be seen from behind:
// then the whole picture is turned over with its normals.
real3 bent_normal(Hit hit, Surface surface, real3 color) {
    Tangents tangents = tangents_of(hit.triangle);
    real3 flat_u =
        tangents.along_u - dot_product(tangents.along_u, surface.normal) * surface.normal;
    real3 part = real(2.0f) * color - real3(real(1.0f));
    if (!(dot_product(flat_u, flat_u) > real(0.0f)) || !(dot_product(part, part) > real(0.0f))) {
        return surface.normal;
    }
    real3 u = unit(flat_u);
    real3 v = cross_product(surface.normal, u);
    v = dot_product(v, tangents.along_v) < real(0.0f) ? -v : v;
    real weight_a = real(1.0f) - hit.u - hit.v;
    real3 front = weight_a * triangle_normal(hit.triangle, 0) +
                  hit.u * triangle_normal(hit.triangle, 1) +
                  hit.v * triangle_normal(hit.triangle, 2);
    real side = dot_product(front, surface.normal) < real(0.0f) ? -real(1.0f) : real(1.0f);
    return unit(side * (part.x * u + part.y * v) + part.z * surface.normal);
}
