#pragma once

#include "structure/kd_tree.h"
#include "structure/packed_structure.h"

namespace raysteps {

// The tree under the names and in the form of shaders/layout/kd_tree.glsl, kd_boxes.glsl and
// kd_ropes.glsl.
PackedStructure pack(const KdTree& tree);

} // namespace raysteps
