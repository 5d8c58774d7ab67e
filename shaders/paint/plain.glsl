// The colour of the material everywhere.

vec3 painted_color(ivec2 pixel, Material material) {
    return material.diffuse;
}
