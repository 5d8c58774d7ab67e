#pragma once

#include "structure/bvh.h"
#include "structure/packed_structure.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace raysteps {

// The tree over the triangles with these corners, three a triangle, in the form of
// shaders/layout/bvh.glsl: its nodes once for each octant of directions, and the triangles once
// more in the order of the leaves. That is 256 + 4 bytes a node and 48 a triangle, in time linear
// in both. Throws InputError where the tree has more than 2^26 nodes: the place of one must fit
// into an integer beside the number of an axis.
PackedStructure pack(const Bvh& bvh, std::span<const glm::vec3> corners);

// What the arrays of a packed structure take.
std::size_t bytes_of(const PackedStructure& packed);

} // namespace raysteps
