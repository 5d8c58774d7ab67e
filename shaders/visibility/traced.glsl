// All of the lamp's light, or none where its shadow ray met something.
uniform usampler2D shadow_hits;

vec3 light_share(ivec2 pixel) {
    return is_hit(unpack_hit(texelFetch(shadow_hits, pixel, 0))) ? vec3(0.0) : vec3(1.0);
}
