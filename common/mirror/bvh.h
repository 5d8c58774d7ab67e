#pragma once

#include "mirror/mirror_scene.h"
#include "structure/bvh/bvh.h"

namespace raysteps::mirror {

// The walks through a bounding volume hierarchy, in single or double precision.

template <class Real>
struct BvhSkip {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_skip.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhSkipPadded {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_skip_padded.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhOrdered {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_ordered.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhParent {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_parent.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct BvhStack {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/bvh/bvh_stack.glsl"
#include "mirror/parts.inc"
};

// The buffers of a BVH, exactly as upload gives them to the GPU. Must outlive the mirrors that read
// it.
struct BvhBuffers {
    BvhBuffers(const Bvh& bvh, std::span<const glm::vec3> corners) : packed(pack(bvh, corners)) {}

    PackedStructure packed;
};

// A mirror with the buffers of the scene and those of the tree.
template <class Mirror>
Mirror mirror_of(const SceneBuffers& scene, const BvhBuffers& tree) {
    Mirror mirror = mirror_of<Mirror>(scene);
    mirror.bvh_nodes.vectors = tree.packed.integer_vectors.at("bvh_nodes");
    mirror.bvh_triangles.vectors = tree.packed.integer_vectors.at("bvh_triangles");
    mirror.bvh_parents.texels = tree.packed.integers.at("bvh_parents");
    mirror.bvh_node_count = tree.packed.numbers.at("bvh_node_count");
    return mirror;
}

} // namespace raysteps::mirror
