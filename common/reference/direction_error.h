#pragma once

#include "geometry/layout.h"
#include "scene/camera.h"

#include <span>
#include <vector>

namespace raysteps {

// How far the directions of a picture's rays are from the exact ones: of the components, the
// largest difference, in units in the last place (ulp) of the direction's largest component. (An
// ulp of each component by itself would call a harmless error near zero enormous.) The rays come
// row by row, the bottom one first; the result, the top one first, as in Image.
std::vector<float> direction_errors(std::span<const Ray> rays, const Camera& camera, int width,
                                    int height);

} // namespace raysteps
