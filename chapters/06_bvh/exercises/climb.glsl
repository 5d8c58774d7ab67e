// Where the walk goes from the node of that number (the step) when it is done with it.

uvec4 checkpoint(Ray ray, int step) {
    BvhClimb climb = climb_bvh(box_ray(ray), step);
    return uvec4(uint(climb.node), climb.left ? 1u : 0u, 0u, 0u);
}
