#pragma once

#include "hard_cases/aimed_rays.h"
#include "structure/grid/build_grid.h"
#include "structure/kd_tree/build_kd_tree.h"

#include <utility>
#include <vector>

namespace raysteps {

// Rays that know where a grid and a kd-tree over the triangles have their planes.
inline std::vector<RayFamily> plane_families(RandomNumbers& numbers,
                                             std::span<const glm::vec3> corners, int count) {
    const Lattice lattice = lattice_of(build_grid(corners, {}).shape);
    const KdTree tree = build_kd_tree(corners, {});
    std::vector<RayFamily> families = lattice_families(numbers, lattice, count);
    families.push_back({"in split planes", rays_in_split_planes(numbers, tree, count)});
    families.push_back({"at corners of nodes", rays_at_box_corners(numbers, tree, corners, count)});
    return families;
}

} // namespace raysteps
