// The triangles of a leaf, from a given one to the last, as far as the rounds allow.

struct BvhLeaf {
    Hit nearest;
    int triangle; // the next one; no_bvh_triangle where the leaf is done
    int left;     // rounds
    bool found;   // a hit that is near enough to end the walk
};

BvhLeaf test_bvh_leaf(PreparedRay ray, Hit nearest, int triangle, real near_enough, int left) {
    BvhLeaf leaf;
    leaf.nearest = nearest;
    leaf.triangle = triangle;
    leaf.left = left;
    leaf.found = false;
    while (leaf.left > 0 && leaf.triangle >= 0) {
        BvhTriangle tested = bvh_triangle(leaf.triangle);
        observe_test(tested.number);
        Hit hit = intersect_triangle(ray, tested.a, tested.b, tested.c, tested.number);
        leaf.triangle = tested.last ? no_bvh_triangle : leaf.triangle + 1;
        if (is_nearer(hit, leaf.nearest)) {
            leaf.nearest = hit;
            leaf.found = hit.t <= near_enough;
            leaf.triangle = leaf.found ? no_bvh_triangle : leaf.triangle;
        }
        leaf.left = leaf.left - 1;
    }
    return leaf;
}
