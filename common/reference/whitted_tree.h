#pragma once

#include "image/image.h"
#include "reference/whitted.h"
#include "scene/scene.h"

#include <vector>

namespace raysteps {

// Optics of clear bodies, in double, from the textbook's formulas by angles.

// The part of unpolarised light that a surface between media of these indices reflects, by the
// angle between ray and normal; 1 where the reflection is total. (Hecht, "Optics", 5th ed., 2017,
// equations 4.34 and 4.40.)
double fresnel_by_angle(double angle, double index_before, double index_behind);

// The part of the light that a material lets through, as its MTL statements d and illum say.
double clear_part(const Material& material);

// Materials of the bodies that a ray is inside of, the innermost last.
using Bodies = std::vector<const Material*>;

// What a ray passes from and to at a surface of that material; `outside` where it meets the outer
// side.
struct Passage {
    Bodies before;
    Bodies behind;
};

Passage passage(const Bodies& inside, const Material* material, bool outside);

// Of air, 1, where the ray is inside of nothing.
double index_of(const Bodies& bodies);

// What absorption leaves after so much of a way (Beer's law).
glm::dvec3 left_after(const Material& material, double distance);

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
