// Where the walk goes on, by a stack whose top, and whose lowest place, are given.

uvec4 checkpoint(Ray ray, int step) {
    Bvh4Stack stack;
    stack.upper = ivec4(int(ray.origin.x), no_bvh4_place, no_bvh4_place, no_bvh4_place);
    stack.lower = ivec4(no_bvh4_place, no_bvh4_place, no_bvh4_place, int(ray.origin.y));
    stack.forgotten = ray.direction.x > real(0.0f);
    return uvec4(uint(next_bvh4_place(stack, int(ray.origin.z))), 0u, 0u, 0u);
}
