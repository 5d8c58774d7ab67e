// The distance as a grey that falls to black, half bright where the eye's distance to the target
// ends.
uniform float middle_distance;

vec3 color_of_hit(Ray ray, Hit hit) {
    float way = hit.t * length(vec3(ray.direction));
    return vec3(exp2(-way / middle_distance));
}
