// All of the lamp's light, or none where its shadow ray met something.
uniform usampler2DArray shadow_hits;

vec3 light_share(ivec2 pixel) {
    return is_hit(hit_at(shadow_hits, pixel)) ? vec3(0.0) : vec3(1.0);
}
