#pragma once

#include "structure/packed_structure.h"

#include <cstdint>

namespace raysteps {

// The box that all halves of a tree are shares of (shaders/layout/half_bvh.glsl).
struct HalfFrame {
    glm::vec3 lower{0.0f};
    glm::vec3 size{0.0f};
};

// The plane that the bits of a half stand for along one axis: the same sum as in the walk.
float half_plane(const HalfFrame& frame, int axis, int bits);

// The bits of the last half whose plane is not over the value, and of the first one whose plane is
// not under it. The value lies within the frame.
int half_below(const HalfFrame& frame, int axis, float value);
int half_above(const HalfFrame& frame, int axis, float value);

// A packed BVH (structure/bvh_pack.h) in the form of shaders/layout/half_bvh.glsl: boxes in half
// precision, rounded outwards, for one order of the nodes. 16 bytes a node.
PackedStructure with_half_boxes(const PackedStructure& bvh);

} // namespace raysteps
