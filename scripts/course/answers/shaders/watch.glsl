// Watches the whole walk: x counts visits, y tests; z and w depend on which places and triangles
// they were, and on their order.
uvec4 watched = uvec4(0u);

void observe_from(uvec4 observed) {
    watched = observed;
}

void observe_visit(int place) {
    watched.x = watched.x + 1u;
    watched.z = (31u * watched.z + uint(place) + 1u) % 1000003u;
}

void observe_test(int triangle) {
    watched.y = watched.y + 1u;
    watched.w = (31u * watched.w + uint(triangle) + 1u) % 1000003u;
}

uvec4 observations() {
    return watched;
}
