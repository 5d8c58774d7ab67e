// Counts what a walk does: x visits of cells or nodes, y tests of triangles.
uvec4 counted = uvec4(0u);

void observe_from(uvec4 observed) {
    counted = observed;
}

void observe_visit(int place) {
    counted.x = counted.x + 1u;
}

void observe_test(int triangle) {
    counted.y = counted.y + 1u;
}

uvec4 observations() {
    return counted;
}
