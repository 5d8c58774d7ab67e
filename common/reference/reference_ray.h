#pragma once

#include "geometry/layout.h"
#include "scene/camera.h"

#include <glm/vec3.hpp>

#include <limits>

namespace raysteps {

// The points origin + t * direction with t_min <= t <= t_max, in double.
// The direction need not have length 1; t counts lengths of the direction.
struct ReferenceRay {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};
    double t_min = 0.0;
    double t_max = std::numeric_limits<double>::infinity();
};

// The same ray in double: nothing is rounded.
ReferenceRay reference_ray(const Ray& ray);

// The ray from the eye through a picture of width * height pixels. Column 0 is left, row 0 is the
// top; whole numbers mean the centre of a pixel, so column + 0.25 is a quarter pixel right of it.
ReferenceRay reference_ray(const Camera& camera, int width, int height, double column, double row);

} // namespace raysteps
