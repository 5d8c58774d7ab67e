#pragma once

#include "structure/bvh/bvh.h"

#include <glm/vec3.hpp>

#include <span>

namespace raysteps {

// The bounding volume hierarchy over the triangles (three corners each) by the rule
// options.split. It does not depend on the number of threads. A builder sees the padded boxes of
// the triangles only, so a walk finds the same hits in the tree of any rule.
//
// Throws InputError where the options make no sense, where a corner is not finite or farther out
// than 1e37, where there are more than 2^28 triangles, and where the tree could take more than
// memory_limit: 68 bytes a triangle, before they are taken.
Bvh build_bvh(std::span<const glm::vec3> corners, const BvhOptions& options);

} // namespace raysteps
