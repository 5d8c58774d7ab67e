#pragma once

#include "structure/kd_tree/kd_tree.h"

#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <vector>

namespace raysteps {

// The checks that check_kd_tree is made of. Each needs those before it to have found nothing.
using KdFaults = std::vector<std::string>;

KdFaults faults_of_links(const KdTree& tree);
KdFaults faults_of_boxes(const KdTree& tree);
KdFaults faults_of_references(const KdTree& tree, std::size_t triangles);
KdFaults faults_of_ropes(const KdTree& tree);
KdFaults missing_references(const KdTree& tree, std::span<const glm::vec3> corners);

// What is wrong with the tree over these triangles (three corners each), a sentence for each fault,
// ten of a kind at most; empty where the tree is right:
// - every node is the child of the one that it calls its parent, and is reached once;
// - children share their parent's box at the split, and are no thinner than 8 paddings;
// - leaves have all references among them, each leaf in ascending order, and no other node has any;
// - a triangle is listed wherever a ray can need it: where it meets a leaf's box grown by 25/32 of
//   the padding, which is what structure/padding.h proves (the rest is room for the builder's
//   rounding);
// - a rope leads to the smallest node that holds the whole face behind it, or is missing at the
//   sides of the root.
std::vector<std::string> check_kd_tree(const KdTree& tree, std::span<const glm::vec3> corners);

} // namespace raysteps
