#pragma once

#include "basics/ray.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <limits>
#include <span>
#include <vector>

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

// How far the directions of a picture's rays are from the exact ones: of the components, the
// largest difference, in units in the last place (ulp) of the direction's largest component. (An
// ulp of each component by itself would call a harmless error near zero enormous.) The rays come
// row by row, the bottom one first; the result, the top one first, as in Image.
std::vector<float> direction_errors(std::span<const Ray> rays, const Camera& camera, int width,
                                    int height);

} // namespace raysteps
