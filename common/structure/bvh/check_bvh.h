#pragma once

#include "structure/bvh/bvh.h"
#include "structure/bvh/bvh4.h"

#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <vector>

namespace raysteps {

// What is wrong with the tree over these triangles, a sentence for each fault, ten of a kind at
// most; empty where the tree is right. Beside what find_faults has
// (structure/bvh/find_faults.h):
// - the padding is at least that for rays from around the scene (structure/padding.h), and a box
//   holds its triangles grown by it;
// - children stand behind their parent;
// - no leaf has more than leaf_triangles, and has them in ascending order.
std::vector<std::string> check_bvh(const Bvh& bvh, std::span<const glm::vec3> corners);

// The same of a tree with up to four children a node. There, of the links:
// - a node stands behind its parent, is the child of it alone, and knows its place there;
// - every node has a first child, and empty places stand behind the others.
std::vector<std::string> check_bvh4(const Bvh4& bvh, std::span<const glm::vec3> corners);

} // namespace raysteps
