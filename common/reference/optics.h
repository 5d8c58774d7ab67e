#pragma once

#include "reference/exact.h"
#include "reference/reference_ray.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace raysteps {

// The part of unpolarised light that a surface between media of these indices reflects, by the
// angle between ray and normal; 1 where the reflection is total. (Hecht, "Optics", 5th ed., 2017,
// equations 4.34 and 4.40.)
double fresnel_by_angle(double angle, double index_before, double index_behind);

// What rays meet at surfaces, in double, for the renderers of this module.
namespace optics {

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

// The part of the light that a material lets through, as its MTL statements d and illum say.
double clear_part(const Material& material);

// Materials of the bodies that a ray is inside of, the innermost last.
using Bodies = std::vector<const Material*>;

// What a ray passes from and to at a surface.
struct Passage {
    Bodies before;
    Bodies behind;
};

// At a surface of that material; `outside` where the ray meets its outer side.
Passage passage(const Bodies& inside, const Material* material, bool outside);

// Of air, 1, where the ray is inside of nothing.
double index_of(const Bodies& bodies);

// What absorption leaves after so much of a way (Beer's law).
glm::dvec3 left_after(const Material& material, double distance);

glm::dvec3 sky_seen(const Scene& scene, const glm::dvec3& direction);

bool is_outer_side(const Scene& scene, const ReferenceRay& ray, const ReferenceHit& hit);

glm::dvec3 point_behind(const Surface& surface);

glm::dvec3 mirror_direction(const Surface& surface, const glm::dvec3& direction);

// Where a ray that meets glass goes on.
struct GlassWays {
    Passage bodies; // before: of the reflected ray; behind: of the refracted one
    double reflected_part = 0.0;
    ReferenceRay reflected;
    ReferenceRay refracted; // where not all is reflected
};

GlassWays ways_at_glass(const ReferenceRay& ray, const Surface& surface, const Bodies& inside,
                        bool outside);

} // namespace optics

} // namespace raysteps
