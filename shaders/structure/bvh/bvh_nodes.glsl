// A bounding volume hierarchy that is walked without a stack. Its nodes lie one after the other as
// a ray meets them: a node, then its near branch, then its far one. There is an order for each of
// the 8 octants of directions, one behind the other; octant 0 ascends along every axis, and 1, 2
// and 4 are added where x, y and z descend. A node is two texels of four integers:
//   bits of the planes x, y, z that a ray of the octant comes to first; skip;
//   bits of the planes that it comes to last; link.
// skip is the node behind the whole branch, -1 at the end. The link of a leaf is its first
// triangle; that of an inner node is -1 - (4 * second child + axis that its children lie along).
uniform isamplerBuffer bvh_nodes;
uniform isamplerBuffer bvh_parents; // of the nodes of octant 0; -1 of the root

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
