#pragma once

#include "reference/reference_hit.h"
#include "reference/reference_ray.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

namespace raysteps {

// What the shading needs of a point where a ray met the scene. Both normals have length 1 and lie
// on the side that the ray came from.
struct Surface {
    glm::dvec3 point{0.0};
    glm::dvec3 geometric_normal{0.0};
    glm::dvec3 shading_normal{0.0}; // the corners' normals, mixed; the geometric one if they cancel
    glm::dvec3 point_above{0.0};    // the point moved just off the surface: where rays leave it
    const Material* material = nullptr;
};

// The hit must be of a triangle of the scene, by this ray.
Surface surface_at(const Scene& scene, const ReferenceRay& ray, const ReferenceHit& hit);

} // namespace raysteps
