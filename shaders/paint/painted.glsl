// The colour that pass/effect/paint_surface.frag has found for the pixel.
uniform sampler2D paint;

vec3 painted_color(ivec2 pixel, Material material) {
    return vec3(texelFetch(paint, pixel, 0));
}
