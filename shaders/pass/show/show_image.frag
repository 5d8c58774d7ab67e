#version 410 core
// A picture on the screen: magnified to fill it, and encoded in sRGB.

uniform sampler2D picture; // linear, components in [0, 1]
uniform vec2 size;         // of the screen, in pixels

out vec4 color;

vec3 nearest_texel(ivec2 texel) {
    return vec3(texelFetch(picture, clamp(texel, ivec2(0), textureSize(picture, 0) - 1), 0));
}

// The four texels around a place, each the more the nearer it is; at its centre a texel alone.
vec3 magnified(vec2 place) {
    ivec2 lower = ivec2(floor(place - 0.5));
    vec2 part = place - 0.5 - vec2(lower);
    vec3 below = mix(nearest_texel(lower), nearest_texel(lower + ivec2(1, 0)), part.x);
    vec3 above =
        mix(nearest_texel(lower + ivec2(0, 1)), nearest_texel(lower + ivec2(1, 1)), part.x);
    return mix(below, above, part.y);
}

// IEC 61966-2-1:1999, "Default RGB colour space - sRGB".
vec3 srgb_from_linear(vec3 linear) {
    vec3 curved = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    return mix(curved, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

void main() {
    vec2 texels_a_pixel = vec2(textureSize(picture, 0)) / size;
    color = vec4(srgb_from_linear(magnified(gl_FragCoord.xy * texels_a_pixel)), 1.0);
}
