// The distance as a grey: a quarter bright where the camera's target lies, an eighth of that way
// nearer twice as bright.
uniform float middle_distance;

vec3 color_of_hit(Ray ray, Hit hit) {
    float way = float(hit.t) * length(vec3(ray.direction)) / middle_distance;
    return vec3(exp2(8.0f * (1.0f - way) - 2.0f));
}
