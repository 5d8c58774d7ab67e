#pragma once

#include "image/image.h"
#include "reference/exact.h"
#include "reference/reference_ray.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <vector>

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

// The scene by recursive ray tracing in double, one ray through the centre of each pixel, on all
// cores (Whitted, "An improved illumination model for shaded display", 1980): diffuse surfaces,
// point lights with hard shadows, and perfect mirrors, which are followed max_bounces times; what a
// path would see after that is black. Pictures on surfaces are ignored. Throws InputError where
// width or height is under 1, or max_bounces is not in 0 ... 1000.
Image render_whitted(const Scene& scene, int width, int height, int max_bounces);

// How much a pixel hangs on where exactly its ray goes: the largest change of a colour channel when
// the ray moves by `shift` pixels left, right, up or down. It is large where an edge, the border of
// a shadow, or one seen in a mirror passes within the shift of the pixel's centre, so a comparison
// with a renderer in float can excuse such pixels. Row by row as in Image. Throws as
// render_whitted.
std::vector<double> whitted_sensitivity(const Scene& scene, int width, int height, int max_bounces,
                                        double shift);

} // namespace raysteps
