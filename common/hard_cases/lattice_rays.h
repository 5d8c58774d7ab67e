#pragma once

#include "hard_cases/ray_families.h"
#include "structure/grid_shape.h"

// Rays that know where a grid has its planes.
namespace raysteps {

// Planes at lower + i * step along each axis, i = 0 ... cells.
struct Lattice {
    glm::vec3 lower{0.0f};
    glm::vec3 step{1.0f};
    glm::ivec3 cells{1};
};

Lattice lattice_of(const GridShape& shape);

glm::vec3 any_lattice_point(RandomNumbers& numbers, const Lattice& lattice);

// From a lattice point to a lattice point, both moved out of the lattice along the ray by its
// length: they run through many lattice points on the way, and along edges of cells.
std::vector<Ray> rays_through_lattice_points(RandomNumbers& numbers, const Lattice& lattice,
                                             int count);

// In a plane of the lattice, in any direction.
std::vector<Ray> rays_in_lattice_planes(RandomNumbers& numbers, const Lattice& lattice, int count);

// Both, and the first ones back again.
std::vector<RayFamily> lattice_families(RandomNumbers& numbers, const Lattice& lattice, int count);

} // namespace raysteps
