// What is left of the lamp's light behind the glass before it; nothing where it met more than
// glass.
uniform sampler2D light_shares;

vec3 light_share(ivec2 pixel) {
    return vec3(texelFetch(light_shares, pixel, 0));
}
