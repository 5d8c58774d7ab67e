#pragma once

#include "structure/bvh/box_tree.h"
#include "structure/faults.h"

#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <vector>

namespace raysteps {

// The kinds of faults that find_faults names.
inline const std::string fault_of_link = "link out of range";
inline const std::string fault_of_cycle = "cycle";
inline const std::string fault_of_second_parent = "node reached twice";
inline const std::string fault_of_lost_node = "node never reached";
inline const std::string fault_of_numbers = "box that is not finite";
inline const std::string fault_of_sides = "box inside out";
inline const std::string fault_of_empty_leaf = "empty leaf";
inline const std::string fault_of_range = "leaf outside the list of triangles";
inline const std::string fault_of_triangle = "triangle number out of range";
inline const std::string fault_of_lost_triangle = "triangle in no leaf";
inline const std::string fault_of_double = "triangle in several leaves";
inline const std::string fault_of_leaf_box = "box does not enclose its triangle";
inline const std::string fault_of_child_box = "box does not enclose its child";
// And what need be no fault.
inline const std::string remark_of_tight_box = "box with less room than the padding";
inline const std::string remark_of_no_area = "triangle without area in no leaf";

struct TreeFindings {
    FaultList faults;
    FaultList remarks;
};

// All that is wrong with any hierarchy of boxes over these triangles (three corners each). What it
// says of triangles and boxes is of the part that can be reached. Where the tree has splits, a
// triangle may be in several leaves: then 28 of its points, among them the corners, must each lie
// in the box of a leaf that lists it. The padding is what our own walks need around a triangle
// (structure/padding.h).
TreeFindings find_faults(const BoxTree& tree, std::span<const glm::vec3> corners, double padding);

// What is wrong with the tree over these triangles, a sentence for each fault, ten of a kind at
// most; empty where the tree is right. Beside what find_faults has:
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
