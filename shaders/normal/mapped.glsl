// The normal that pass/effect/bend_normals.frag has found for the pixel.
uniform sampler2D bent_normals;

Surface with_normal(ivec2 pixel, Surface surface) {
    surface.normal = vec3(texelFetch(bent_normals, pixel, 0));
    return surface;
}
