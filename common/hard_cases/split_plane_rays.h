#pragma once

#include "hard_cases/ray_families.h"
#include "structure/kd_tree.h"

// Rays that are aimed at the planes of a kd-tree itself, where a walk can go wrong.
namespace raysteps {

const Box& any_box(RandomNumbers& numbers, const KdTree& tree);

glm::vec3 any_box_corner(RandomNumbers& numbers, const KdTree& tree);

// At corners of boxes, where up to eight leaves meet.
std::vector<Ray> rays_at_box_corners(RandomNumbers& numbers, const KdTree& tree,
                                     std::span<const glm::vec3> corners, int count);

// From corner to corner of boxes, from before the first to behind the second.
std::vector<Ray> rays_through_box_corners(RandomNumbers& numbers, const KdTree& tree, int count);

// In a plane of the tree: one component of the direction is a zero of either sign.
std::vector<Ray> rays_in_box_planes(RandomNumbers& numbers, const KdTree& tree,
                                    std::span<const glm::vec3> corners, int count);

// In the plane of a split, in any direction from within the node that it splits.
std::vector<Ray> rays_in_split_planes(RandomNumbers& numbers, const KdTree& tree, int count);

// Along an edge of a box: in two planes at once.
std::vector<Ray> rays_along_box_edges(RandomNumbers& numbers, const KdTree& tree, int count);

std::vector<RayFamily> tree_families(RandomNumbers& numbers, const KdTree& tree,
                                     std::span<const glm::vec3> corners, int count);

} // namespace raysteps
