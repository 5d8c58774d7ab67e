#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <vector>

namespace raysteps {

// How far the tree of rays is followed: so many bounces, and no path that counts at most `faintest`
// in every channel.
struct TreeLimits {
    int max_bounces = 8;
    double faintest = 0.0;
};

// The scene by recursive ray tracing in double, one ray through the centre of each pixel, on all
// cores (Whitted, "An improved illumination model for shaded display", 1980): what render_whitted
// shows, and glass (reflected and refracted rays, nested bodies, absorption), highlights, a sky,
// and the light that comes straight through glass. Lights with an area count as their middle;
// pictures on surfaces and the lens of the camera are ignored. Throws InputError where the picture
// has no pixel or max_bounces is not in 0 ... 1000.
Image render_tree(const Scene& scene, int width, int height, const TreeLimits& limits);

// How much a pixel hangs on where exactly its ray goes, as whitted_sensitivity.
std::vector<double> tree_sensitivity(const Scene& scene, int width, int height,
                                     const TreeLimits& limits, double shift);

} // namespace raysteps
