// What all walks through a hierarchy have in common: what a node is to them, and the test of the
// triangles of a leaf.
//
// A triangle is three texels: the bits of a corner in x, y and z; in w its number in the scene, 1
// where it is the last of its leaf, and nothing. So a leaf is read in one go.
uniform isamplerBuffer bvh_triangles;
uniform int bvh_node_count; // of one order of the nodes

const int no_bvh_node = -1;
const int no_bvh_triangle = -1;

struct BvhNode {
    real3 first_planes;
    real3 last_planes;
    int skip;
    int link;
};

bool is_bvh_leaf(BvhNode node) {
    return node.link >= 0;
}

real3 bvh_point(ivec4 texel) {
    return real3(intBitsToFloat(texel.x), intBitsToFloat(texel.y), intBitsToFloat(texel.z));
}

struct BvhTriangle {
    real3 a;
    real3 b;
    real3 c;
    int number;
    bool last;
};

BvhTriangle bvh_triangle(int place) {
    ivec4 a = texelFetch(bvh_triangles, 3 * place);
    ivec4 b = texelFetch(bvh_triangles, 3 * place + 1);
    ivec4 c = texelFetch(bvh_triangles, 3 * place + 2);
    BvhTriangle triangle;
    triangle.a = bvh_point(a);
    triangle.b = bvh_point(b);
    triangle.c = bvh_point(c);
    triangle.number = a.w;
    triangle.last = b.w != 0;
    return triangle;
}

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
        if (is_nearer(hit, leaf.nearest) && is_solid(hit)) {
            leaf.nearest = hit;
            leaf.found = hit.t <= near_enough;
            leaf.triangle = leaf.found ? no_bvh_triangle : leaf.triangle;
        }
        leaf.left = leaf.left - 1;
    }
    return leaf;
}
