#pragma once

#include "scene/mesh.h"
#include "scene/random_numbers.h"

namespace raysteps {

// A mesh of these corners, three a triangle; its normals are those of the triangles, and (0, 0, 1)
// where a triangle has none.
Mesh mesh_of(std::vector<glm::vec3> corners);

// Triangles without order in and around the cube from -1 to 1.
Mesh random_triangles(RandomNumbers& numbers, int count);

// The same, but a thousand times longer than wide.
Mesh random_slivers(RandomNumbers& numbers, int count);

// The mesh with all corners in one plane across that axis.
Mesh flattened(Mesh mesh, int axis, float place);

} // namespace raysteps
