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
// cores (Whitted, "An improved illumination model for shaded display", 1980): diffuse surfaces,
// point lights with hard shadows, perfect mirrors, glass (reflected and refracted rays, nested
// bodies, absorption), highlights, a sky, and the light that comes straight through glass. Lights
// with an area count as their middle; textures and the lens of the camera are ignored. What a path
// would see after its last bounce is black. Throws InputError where width or height is under 1, or
// max_bounces is not in 0 ... 1000.
Image render_whitted(const Scene& scene, int width, int height, const TreeLimits& limits);

// How much a pixel depends on where exactly its ray goes: the largest change of a colour channel
// when the ray moves by `shift` pixels left, right, up or down. It is large where an edge, the
// border of a shadow, or one seen in a mirror passes within the shift of the pixel's centre, so a
// comparison with a renderer in float can excuse such pixels. Row by row as in Image. Throws as
// render_whitted.
std::vector<double> whitted_sensitivity(const Scene& scene, int width, int height,
                                        const TreeLimits& limits, double shift);

// The scene as chapter 03 shows it: without glass, highlights and a sky.
Scene without_optics(Scene scene);

} // namespace raysteps
