// The barycentric coordinates of the hit: red at corner a, green at b, blue at c.

vec3 color_of_hit(Ray ray, Hit hit) {
    return vec3(1.0f - float(hit.u) - float(hit.v), float(hit.u), float(hit.v));
}
