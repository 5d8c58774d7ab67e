#pragma once

#include "scene/mesh.h"

namespace raysteps {

// Closed meshes around the world's origin that are harder than a ball of even triangles.

// A sphere of that radius by lines of latitude and longitude: 2 * around * (rows - 1) triangles. At
// the poles as many triangles as there are around share one corner.
Mesh latitude_sphere(float radius, int rows, int around);

// The sphere with 1,520 triangles and the radius 2.
Mesh shared_edge_sphere();

// A sphere of radius 1, drawn out along x: slivers as many times longer than wide.
Mesh sliver_ball(float times);

// A lens of radius 1, and so high in its middle: from inside, rays to its rim graze its faces.
Mesh flat_lens(float height);

// The mesh, each corner multiplied and then moved, with rounding.
Mesh scaled_and_moved(Mesh mesh, float scale, const glm::vec3& offset);

} // namespace raysteps
