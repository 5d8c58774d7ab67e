// The boxes of a kd-tree's nodes: node i has its lower corner in texel 2i and its upper one in
// 2i + 1 (the fourth number is unused).
uniform samplerBuffer kd_boxes;

real3 kd_box_lower(int place) {
    return real3(texelFetch(kd_boxes, 2 * place));
}

real3 kd_box_upper(int place) {
    return real3(texelFetch(kd_boxes, 2 * place + 1));
}
