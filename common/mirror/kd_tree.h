#pragma once

#include "mirror/mirror_scene.h"
#include "structure/kd_tree/kd_tree.h"

namespace raysteps::mirror {

// The walks through a kd-tree. In single precision only: the place of a walk holds its t as a
// float.

template <class Real>
struct KdRestart {
    static_assert(sizeof(Real) == sizeof(float));
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/kd_tree/kd_restart.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct KdBacktrack {
    static_assert(sizeof(Real) == sizeof(float));
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/kd_tree/kd_backtrack.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct KdShortStack {
    static_assert(sizeof(Real) == sizeof(float));
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/kd_tree/kd_short_stack.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct KdRopesWalk {
    static_assert(sizeof(Real) == sizeof(float));
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/kd_tree/kd_ropes.glsl"
#include "mirror/parts.inc"
};

// The buffers of a kd-tree, exactly as upload gives them to the GPU. Must outlive the mirrors that
// read it.
struct KdBuffers {
    explicit KdBuffers(const KdTree& tree) : packed(pack(tree)) {}

    PackedStructure packed;
};

// A mirror with the buffers of the scene and those of the tree that its walk reads.
template <class Mirror>
Mirror mirror_of(const SceneBuffers& scene, const KdBuffers& tree) {
    Mirror mirror = mirror_of<Mirror>(scene);
    mirror.kd_nodes.vectors = tree.packed.integer_vectors.at("kd_nodes");
    mirror.kd_references.texels = tree.packed.integers.at("kd_references");
    mirror.kd_lower = tree.packed.points.at("kd_lower");
    mirror.kd_upper = tree.packed.points.at("kd_upper");
    if constexpr (requires { mirror.kd_boxes; }) {
        mirror.kd_boxes.texels = tree.packed.vectors.at("kd_boxes");
    }
    if constexpr (requires { mirror.kd_ropes; }) {
        mirror.kd_ropes.texels = tree.packed.integers.at("kd_ropes");
    }
    return mirror;
}

} // namespace raysteps::mirror
