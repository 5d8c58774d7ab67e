// The near and the far child of node 5, whose second child is node 12, along each axis in turn: the
// step says which.

uvec4 checkpoint(Ray ray, int step) {
    BvhChildren children = bvh_children(box_ray(ray), 5, -1 - (4 * 12 + step - 1));
    return uvec4(uint(children.near), uint(children.far), 0u, 0u);
}
