#pragma once

#include "hard_cases/ray_families.h"
#include "scene/mesh.h"

namespace raysteps {

// Rays from inside a closed mesh around the world's origin. Each must hit: one that does not has
// leaked out. Random rays are nearly blind for leaks, these are aimed at where they are. Origins
// lie in the cube of that half side; directions are not normalised.

// At any point of any edge.
std::vector<Ray> edge_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, const glm::vec3& half,
                                 int count);

// At any corner exactly, or as near as a rounded difference can be.
std::vector<Ray> corner_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, const glm::vec3& half,
                                   int count);

// In any direction: to compare with.
std::vector<Ray> random_rays_from_inside(RandomNumbers& numbers, const glm::vec3& half, int count);

} // namespace raysteps
