// A bounding volume hierarchy with boxes of half precision, rounded outwards: half the memory a
// node, larger boxes, and the same hits. Walked as bvh_skip is. Source of the idea: Mahovsky and
// Wyvill, "Memory-Conserving Bounding Volume Hierarchies with Coherent Raytracing", 2006.
//
// A node is one texel of four integers, half as long as those of structure/bvh/bvh_nodes.glsl. Six
// halves say where its box begins and ends, as shares of the whole scene's box, from 0 to 1: x has
// the lower planes of x and y, y that of z and the upper one of x, z the upper ones of y and z, the
// first in the low 16 bits. w of an inner node is the node behind its whole branch; that of a leaf
// is -1 - its first triangle, and the next node stands behind it.
//
// A half has 1 sign, 5 digits of exponent and 10 of mantissa. There are no negative ones here, and
// none that is denormal, so its bits are those of a float, shifted.
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_plain.glsl"
#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh_choose_planes.glsl"

uniform isamplerBuffer half_nodes;
uniform vec3 half_lower; // the box of the whole scene, and its size
uniform vec3 half_size;

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

Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.ended = is_empty(ray) || bvh_node_count == 0;
    walk.place = ivec3(0, no_bvh_triangle, 0);
    return walk;
}

// While there are nodes, on to the next leaf, then through its triangles: rays that a processor
// runs side by side then wait for each other in two short loops, rather than at each node.
Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    BoxRay for_boxes = box_ray(ray);
    PreparedRay for_triangles = prepare_ray(ray);
    Hit nearest = walk.nearest;
    int node = walk.place.x;
    int triangle = walk.place.y;
    int left = rounds;
    while (left > 0 && (node >= 0 || triangle >= 0)) {
        while (left > 0 && node >= 0 && triangle < 0) {
            observe_visit(node);
            BvhNode here = bvh_node(node);
            bool met = meets_bvh_node(for_boxes, here, nearest.t);
            triangle = met ? max(here.link, no_bvh_triangle) : no_bvh_triangle;
            node = met && !is_bvh_leaf(here) ? node + 1 : here.skip;
            --left;
        }
        BvhLeaf leaf = test_bvh_leaf(for_triangles, nearest, triangle, near_enough, left);
        nearest = leaf.nearest;
        triangle = leaf.triangle;
        left = leaf.left;
        node = leaf.found ? no_bvh_node : node;
    }
    walk.nearest = nearest;
    walk.place = ivec3(node, triangle, 0);
    walk.ended = node < 0 && triangle < 0;
    return walk;
}
