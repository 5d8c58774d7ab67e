// Each triangle in a colour of its own, scattered by its number.

vec3 color_of_hit(Ray ray, Hit hit) {
    uint number = uint(hit.triangle) * 2654435761u; // Knuth's multiplicative hash
    return vec3(float(number >> 24), float((number >> 16) & 255u), float((number >> 8) & 255u)) /
           255.0f;
}
