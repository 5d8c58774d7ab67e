// A kd-tree. Node 0 is the root. A node is one texel of four integers:
//   inner: axis of the split (0, 1, 2), bits of the split, first child, parent;
//   leaf:  3 + 4 * number of the leaf, first reference, end of its references, parent.
// The children stand side by side: first_child is below the split, first_child + 1 above. The
// references are numbers of triangles.
uniform isamplerBuffer kd_nodes;
uniform isamplerBuffer kd_references;
uniform vec3 kd_lower; // the box of the root
uniform vec3 kd_upper;

const int kd_root = 0;
const int kd_leaf = 3; // as the axis of a node that has none

struct KdNode {
    int axis;
    real split;          // of an inner node
    int first_child;     // of an inner node
    int first_reference; // of a leaf
    int end_reference;   // of a leaf
    int leaf;            // of a leaf: its number
};

KdNode kd_node(int place) {
    ivec4 texel = texelFetch(kd_nodes, place);
    KdNode node;
    node.axis = texel.x & 3;
    node.split = real(intBitsToFloat(texel.y));
    node.first_child = texel.z;
    node.first_reference = texel.y;
    node.end_reference = texel.z;
    node.leaf = texel.x >> 2;
    return node;
}

int kd_parent(int place) {
    return texelFetch(kd_nodes, place).w;
}

// The boxes of a kd-tree's nodes: node i has its lower corner in texel 2i and its upper one in
// 2i + 1 (the fourth number is unused).
uniform samplerBuffer kd_boxes;

real3 kd_box_lower(int place) {
    return real3(texelFetch(kd_boxes, 2 * place));
}

real3 kd_box_upper(int place) {
    return real3(texelFetch(kd_boxes, 2 * place + 1));
}

// The ropes of a kd-tree's leaves, six a leaf: behind its lower face along x, its upper one along
// x, and so on, the smallest node that holds the whole face; -1 where the tree ends.
uniform isamplerBuffer kd_leaf_ropes;

int kd_rope(int leaf, int face) {
    return texelFetch(kd_leaf_ropes, 6 * leaf + face).x;
}
