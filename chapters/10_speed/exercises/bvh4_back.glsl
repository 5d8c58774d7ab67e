// Where the walk goes on, by a stack whose top, and whose lowest place, are given. Places lie on it
// from the top on: where there is none on top, there is none at all.

uvec4 checkpoint(Ray ray, int step) {
    int top = int(ray.origin.x);
    int lowest = top == no_bvh4_place ? no_bvh4_place : int(ray.origin.y);
    Bvh4Stack stack;
    stack.upper = ivec4(top, no_bvh4_place, no_bvh4_place, no_bvh4_place);
    stack.lower = ivec4(no_bvh4_place, no_bvh4_place, no_bvh4_place, lowest);
    stack.forgotten = ray.direction.x > real(0.0f);
    return uvec4(uint(next_bvh4_place(stack, int(ray.origin.z))), 0u, 0u, 0u);
}
