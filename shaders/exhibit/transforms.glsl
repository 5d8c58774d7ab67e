// For each triangle a map of space that makes its plane w = 0 and its corners (0, 0), (1, 0) and
// (0, 1) in u and v: three texels, the rows of u, v and w, each with its constant in w.
uniform samplerBuffer triangle_transforms;

vec4 triangle_transform(int triangle, int row) {
    return texelFetch(triangle_transforms, 3 * triangle + row);
}
