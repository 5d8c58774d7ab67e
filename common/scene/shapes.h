#pragma once

#include "scene/mesh.h"

#include <glm/vec3.hpp>

namespace raysteps {

// A flat triangle, seen from where a, b, c run counter-clockwise. It must have an area.
Mesh triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

// A flat quadrilateral as the triangles a, b, c and a, c, d.
Mesh quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

// The twelve triangles of an axis-aligned box.
Mesh box(const glm::vec3& lower, const glm::vec3& upper);

// A flat tetrahedron; d lies on the side from which a, b, c run clockwise.
Mesh tetrahedron(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

// Twenty flat triangles.
Mesh icosahedron(const glm::vec3& center, float radius);

// An icosahedron whose edges are cut into `divisions` parts: 20 * divisions * divisions triangles
// with smooth normals. All corners lie on the sphere.
Mesh sphere(const glm::vec3& center, float radius, int divisions);

} // namespace raysteps
