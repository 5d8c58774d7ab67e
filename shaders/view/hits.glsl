// Where a ray hits at all.

vec3 color_of_hit(Ray ray, Hit hit) {
    return vec3(0.85f);
}
