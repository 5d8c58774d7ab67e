// The triangles of the scene: triangle i has the corners 3i, 3i + 1 and 3i + 2 (the fourth number
// is unused).
uniform samplerBuffer triangle_corners;

real3 triangle_corner(int triangle, int corner) {
    return real3(texelFetch(triangle_corners, 3 * triangle + corner));
}
