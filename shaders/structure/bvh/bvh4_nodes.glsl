// A bounding volume hierarchy with up to four children a node, in one copy for all directions. A
// node is eight texels of four integers, and all but the last hold one number of each child:
//   2 * axis, 2 * axis + 1: the bits of the lower and of the upper planes along the axis;
//   6: links; 7: in x, the place in the parent behind this node (-1 of the root), and nothing.
//
// A place in the tree is one number. Of a node whose first texel is `texel` it is `texel`, where
// all children are still to be seen; `texel` + 1 + child, where those are that come after this one;
// `texel` + 5, where none is. Of a leaf it is -2 - its first triangle. The link of a child is its
// place. Of an empty one it is no_bvh4_place, and the planes lie where no ray goes.
//
// The planes that a ray comes to first are the lower ones along an axis that it ascends, and the
// upper ones where it descends: only the address differs.
uniform isamplerBuffer bvh4_nodes;

const int no_bvh4_place = -1;
const int bvh4_all_seen = 5;

// What a place is: a node with children that may still be to be seen, one without, or a leaf.

bool has_bvh4_children(int place) {
    return place >= 0 && (place & 7) != bvh4_all_seen;
}

bool is_bvh4_done(int place) {
    return place >= 0 && (place & 7) == bvh4_all_seen;
}

bool is_bvh4_leaf(int place) {
    return place < no_bvh4_place;
}

int bvh4_first_triangle(int leaf) {
    return -2 - leaf;
}

int bvh4_node(int place) {
    return place & ~7;
}

// The last child that was seen; -1 where none was.
int bvh4_last_child(int place) {
    return (place & 7) - 1;
}

real4 bvh4_planes(int texel) {
    return real4(intBitsToFloat(texelFetch(bvh4_nodes, texel)));
}

ivec4 bvh4_links(int node) {
    return texelFetch(bvh4_nodes, node + 6);
}

int bvh4_way_up(int node) {
    return texelFetch(bvh4_nodes, node + 7).x;
}

// Where the ray is within the boxes of the four children, up to t_max: what span_in_box of
// structure/bvh/box_ray.glsl says of one, by the same operations in the same order.
struct Bvh4Spans {
    real4 entry;
    real4 exit;
};

Bvh4Spans bvh4_spans(BoxRay ray, int node, real t_max) {
    precise real4 entry = real4(ray.t_min);
    precise real4 exit = real4(t_max);
    for (int axis = 0; axis < 3; ++axis) {
        int turned = descends(ray, axis) ? 1 : 0;
        real4 first_planes = bvh4_planes(node + 2 * axis + turned);
        real4 last_planes = bvh4_planes(node + 2 * axis + 1 - turned);
        precise real4 enters = (first_planes - ray.first_origin[axis]) * ray.inverse[axis];
        precise real4 leaves = (last_planes - ray.last_origin[axis]) * ray.inverse[axis];
        entry = mix(entry, enters, greaterThan(enters, entry));
        exit = mix(exit, leaves, lessThan(leaves, exit));
    }
    Bvh4Spans spans;
    spans.entry = entry;
    spans.exit = exit;
    return spans;
}
