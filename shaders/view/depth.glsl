// The distance as a grey, half bright where the camera's target lies, a sixth nearer twice as
// bright.
uniform float middle_distance;

vec3 color_of_hit(Ray ray, Hit hit) {
    float way = float(hit.t) * length(vec3(ray.direction)) / middle_distance;
    return vec3(exp2(6.0f * (1.0f - way) - 1.0f));
}
