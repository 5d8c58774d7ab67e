// A bounding volume hierarchy with boxes of half precision: half as long as those of
// structure/bvh/bvh_nodes.glsl, one texel of four integers a node. Six halves tell where the box begins and
// ends, as shares of the whole scene's box, from 0 to 1, rounded outwards: x has the lower planes
// of x and y, y that of z and the upper one of x, z the upper ones of y and z, the first in the low
// 16 bits. w of an inner node is the node behind its whole branch; that of a leaf is -1 - its first
// triangle, and the next node stands behind it.
//
// A half has 1 sign, 5 digits of exponent and 10 of mantissa. There are no negative ones here, and
// none that is denormal, so its bits are those of a float, shifted.
uniform isamplerBuffer half_nodes;
uniform isamplerBuffer bvh_triangles; // as structure/bvh/bvh_nodes.glsl has them
uniform vec3 half_lower;              // the box of the whole scene, and its size
uniform vec3 half_size;
uniform int bvh_node_count;

const int no_bvh_node = -1;
const int no_bvh_triangle = -1;

struct BvhNode {
    real3 first_planes;
    real3 last_planes;
    int skip;
    int link;
};

struct BvhTriangle {
    real3 a;
    real3 b;
    real3 c;
    int number;
    bool last;
};

// 112 is the difference of the biases of both exponents.
real share_of_half(int bits) {
    return bits == 0 ? real(0.0f) : real(intBitsToFloat((bits << 13) + (112 << 23)));
}

// The builder computes the plane by the same sum, and takes the next half until it is outside.
real half_plane(int axis, int bits) {
    precise real plane = real(half_lower[axis]) + real(half_size[axis]) * share_of_half(bits);
    return plane;
}

BvhNode bvh_node(int place) {
    ivec4 texel = texelFetch(half_nodes, place);
    int low = 0xffff;
    BvhNode node;
    node.first_planes = real3(half_plane(0, texel.x & low), half_plane(1, (texel.x >> 16) & low),
                              half_plane(2, texel.y & low));
    node.last_planes = real3(half_plane(0, (texel.y >> 16) & low), half_plane(1, texel.z & low),
                             half_plane(2, (texel.z >> 16) & low));
    bool leaf = texel.w < 0;
    int next = leaf ? place + 1 : texel.w;
    node.skip = next < bvh_node_count ? next : no_bvh_node;
    node.link = leaf ? -1 - texel.w : -1;
    return node;
}

bool is_bvh_leaf(BvhNode node) {
    return node.link >= 0;
}

BvhTriangle bvh_triangle(int place) {
    ivec4 a = texelFetch(bvh_triangles, 3 * place);
    ivec4 b = texelFetch(bvh_triangles, 3 * place + 1);
    ivec4 c = texelFetch(bvh_triangles, 3 * place + 2);
    BvhTriangle triangle;
    triangle.a = real3(intBitsToFloat(a.x), intBitsToFloat(a.y), intBitsToFloat(a.z));
    triangle.b = real3(intBitsToFloat(b.x), intBitsToFloat(b.y), intBitsToFloat(b.z));
    triangle.c = real3(intBitsToFloat(c.x), intBitsToFloat(c.y), intBitsToFloat(c.z));
    triangle.number = a.w;
    triangle.last = b.w != 0;
    return triangle;
}
