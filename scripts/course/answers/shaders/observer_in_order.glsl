// What a walk does: x counts the visits of cells or nodes, y the tests of triangles, and z is a
// digest of both in their order.
uvec4 counted = uvec4(0u);

void observe_from(uvec4 observed) {
    counted = observed;
}

void observe_visit(int place) {
    counted = uvec4(counted.x + 1u, counted.y, 31u * counted.z + 2u * uint(place) + 1u, 0u);
}

void observe_test(int triangle) {
    counted = uvec4(counted.x, counted.y + 1u, 31u * counted.z + 2u * uint(triangle), 0u);
}

uvec4 observations() {
    return counted;
}
