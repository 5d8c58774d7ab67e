#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace raysteps {

// Corners of triangles that tempt the builder of a tree into depth, into endless splits, or out of
// the numbers. Three corners a triangle.

// The triangle with a box of the sides 2 a around the center, but for rounding.
std::vector<glm::vec3> triangle_around(const glm::vec3& center, const glm::vec3& a);

// Triangles of all sizes up to 1 around the world's origin: their boxes have the same centre,
// exactly.
std::vector<glm::vec3> concentric_triangles(int seed, int count);

// Triangles at 2^i along each axis, i = -60 ... 60, each as large as that.
std::vector<glm::vec3> triangles_at_powers_of_two();

// Triangles around the origin, each larger than the one before: a tree that grows by insertion
// becomes a chain.
std::vector<glm::vec3> shells(int count);

// Two heaps of triangles, 1.6e30 apart: their surface areas are no floats.
std::vector<glm::vec3> heaps_at_the_end_of_floats(int seed);

// A box with another one in its corner: half of the planes of one are planes of the other.
std::vector<glm::vec3> box_in_the_corner_of_a_box();

// Small triangles at x = 1, 2, 4 ... 8192: planes that halve the way to them put off thirteen nodes
// before the first leaf, more than a short stack has room for.
std::vector<glm::vec3> triangles_at_doubling_distances();

} // namespace raysteps
