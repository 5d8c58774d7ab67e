#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace raysteps {

struct ReferencePathRequest {
    int width = 1;
    int height = 1;
    int samples = 1; // per pixel
    int max_bounces = 8;
    int seed = 1;
};

// The mean of a pixel's samples, and the variance of that mean as the samples differ.
struct ReferencePixel {
    glm::dvec3 mean{0.0};
    glm::dvec3 variance{0.0};
};

// The scene's radiance by recursion in double, row by row from the top, on all cores (Kajiya, "The
// Rendering Equation", 1986). Lamps are asked for by points that are spread evenly over all that
// glows, and paths that meet a lamp by chance do not count it; so no weights are needed, and none
// are shared with chapter 11. What gives light is as there: surfaces that glow on their front, the
// sky or the background, and the lights as points where nothing glows. Textures, highlights and the
// lens are left out. At most max_bounces surfaces are between a lamp and the eye. Throws InputError
// where a number is out of range.
std::vector<ReferencePixel> follow_reference_paths(const Scene& scene,
                                                   const ReferencePathRequest& request);

} // namespace raysteps
