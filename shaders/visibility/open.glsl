// Nobody asks whether something stands before the lamp.

vec3 light_share(ivec2 pixel) {
    return vec3(1.0);
}
