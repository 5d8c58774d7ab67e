// Boxes: box i has its lower corner in texel 2i and its upper one in 2i + 1 (the fourth number is
// unused).
uniform samplerBuffer boxes;

real3 box_lower(int i) {
    return real3(texelFetch(boxes, 2 * i));
}

real3 box_upper(int i) {
    return real3(texelFetch(boxes, 2 * i + 1));
}
