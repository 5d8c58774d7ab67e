// An observer of which cells or nodes a walk visits, in their order: x counts them, and y is a
// number that hardly any other trail has. Not among the parts of <observer>, since only tests of
// walks ask for it. Source of the mixing: Fowler, Noll and Vo's hash, 1991 (with whole numbers for
// bytes).
uvec4 counted = uvec4(0u, 2166136261u, 0u, 0u);

void observe_from(uvec4 observed) {
    counted = observed;
}

void observe_visit(int place) {
    counted.x = counted.x + 1u;
    counted.y = (counted.y ^ uint(place)) * 16777619u;
}

void observe_test(int triangle) {}

uvec4 observations() {
    return counted;
}
