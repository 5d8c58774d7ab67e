// Makes a direction visible.

// The component that a file shall hold, 0 to 1, as the linear light that sRGB encodes to it.
// Source: IEC 61966-2-1:1999.
float light_of_component(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : pow((encoded + 0.055f) / 1.055f, 2.4f);
}

// A direction of length 1: its components from -1 to 1 are red, green and blue from 0 to 1.
vec3 color_of_direction(vec3 direction) {
    vec3 encoded = 0.5f + 0.5f * direction;
    return vec3(light_of_component(encoded.x), light_of_component(encoded.y),
                light_of_component(encoded.z));
}
