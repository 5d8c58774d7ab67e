// A lamp that is one point.
uniform vec3 light_position;

vec3 lamp_point(ivec2 pixel) {
    return light_position;
}
