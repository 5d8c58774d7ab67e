// A lamp that is a parallelogram: each sample asks another point of it. One without edges is its
// position, to the bit.
uniform vec3 light_position;
uniform vec3 light_across;
uniform vec3 light_along;
uniform int lamp_sample;

vec3 lamp_point(ivec2 pixel) {
    SquarePoint place = point_on_lamp(lamp_sample, pixel.x, pixel.y);
    precise vec3 point =
        light_position + (place.x - 0.5) * light_across + (place.y - 0.5) * light_along;
    return point;
}
