// An observer for steps.frag: x counts visits and y tests; z and w are what the pixel's own event was, of all in their order:
// its place or triangle, and twice the line that told of it, plus 1 for a test.
const int steps_in_row = 64;
uvec4 counted = uvec4(0u);

void observe_from(uvec4 observed) {
    counted = observed;
}

void observe_event(int place, int line, uint is_test) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (int(counted.x + counted.y) == pixel.x + steps_in_row * pixel.y) {
        counted.z = uint(place);
        counted.w = 2u * uint(line) + is_test;
    }
    counted.x = counted.x + 1u - is_test;
    counted.y = counted.y + is_test;
}

#define observe_visit(place) observe_event(place, __LINE__, 0u)
#define observe_test(triangle) observe_event(triangle, __LINE__, 1u)

uvec4 observations() {
    return counted;
}
