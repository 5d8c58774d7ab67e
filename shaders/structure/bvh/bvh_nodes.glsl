// A bounding volume hierarchy that is walked without a stack. Its nodes lie one after the other as
// a ray meets them: a node, then its near branch, then its far one. There is an order for each of
// the 8 octants of directions, one behind the other; octant 0 ascends along every axis, and 1, 2
// and 4 are added where x, y and z descend. A node is two texels of four integers:
//   bits of the planes x, y, z that a ray of the octant comes to first; skip;
//   bits of the planes that it comes to last; link.
// skip is the node behind the whole branch, -1 at the end. The link of a leaf is its first
// triangle; that of an inner node is -1 - (4 * second child + axis that its children lie along).
//
// A triangle is three texels: the bits of a corner in x, y and z; in w its number in the scene, 1
// where it is the last of its leaf, and nothing. So a leaf is read in one go.
uniform isamplerBuffer bvh_nodes;
uniform isamplerBuffer bvh_triangles;
uniform isamplerBuffer bvh_parents; // of the nodes of octant 0; -1 of the root
uniform int bvh_node_count;         // of one octant

const int no_bvh_node = -1;
const int no_bvh_triangle = -1;

struct BvhNode {
    real3 first_planes;
    real3 last_planes;
    int skip;
    int link;
};

real3 bvh_point(ivec4 texel) {
    return real3(intBitsToFloat(texel.x), intBitsToFloat(texel.y), intBitsToFloat(texel.z));
}

BvhNode bvh_node(int place) {
    ivec4 first = texelFetch(bvh_nodes, 2 * place);
    ivec4 last = texelFetch(bvh_nodes, 2 * place + 1);
    BvhNode node;
    node.first_planes = bvh_point(first);
    node.last_planes = bvh_point(last);
    node.skip = first.w;
    node.link = last.w;
    return node;
}

int bvh_link(int place) {
    return texelFetch(bvh_nodes, 2 * place + 1).w;
}

int bvh_parent(int place) {
    return texelFetch(bvh_parents, place).x;
}

bool is_bvh_leaf(BvhNode node) {
    return node.link >= 0;
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
