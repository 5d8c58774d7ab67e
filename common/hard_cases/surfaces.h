#pragma once

#include "hard_cases/ray_families.h"
#include "scene/mesh.h"

namespace raysteps {

// Surfaces that a ray leaves right after it has hit them, where acne and leaks come from.

// A direction of length 1, each equally likely.
glm::vec3 any_direction(RandomNumbers& numbers);

// A mesh and a ray at a point inside its first triangles.
struct SeenSurface {
    Mesh mesh;
    Ray ray;
};

// A triangle of that size, that far from the world's origin, seen from three sizes away.
SeenSurface any_triangle(RandomNumbers& numbers, float size, float offset);

// Two triangles that make a parallelogram, anywhere up to 10 from the origin, in any direction.
SeenSurface any_parallelogram(RandomNumbers& numbers);

// A ball of 80 triangles around zero, of radius 1, seen from outside at any point.
SeenSurface any_point_of_a_ball(RandomNumbers& numbers);

// Two spheres around the origin, of the radii 1 and 1 + gap; the first half of the triangles is the
// inner one.
Mesh close_spheres(float gap);

} // namespace raysteps
