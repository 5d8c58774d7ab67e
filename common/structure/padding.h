#pragma once

#include "basics/box.h"
#include "basics/ray.h"

#include <span>

namespace raysteps {

// How far a structure must take a triangle to reach beyond its corners, so that no walk misses a
// hit by rounding.
//
// Let e = 2^-24, the most by which single precision rounds, and M the greatest distance along one
// axis from a ray's origin to a corner or to a plane of the structure (the reach). A hit of
// triangle/watertight.glsl at t has a point P of its triangle with |origin + t * direction
// - P| <= 23 e M along each axis: 6 e M from the sheared corners, 17 e M from the shares and the
// sum that makes t (docs/numerics.md has each term). A plane's distance (plane - origin) /
// direction is rounded twice, which is 2 e M. So P lies within 25 e M of the cell that the walk
// holds for the one at t. 32 e M leaves room for terms in e^2 and for the arithmetic of the
// builder, which is in double.
double padding_for(double reach);

// The reach that serves rays with origins in the scene or around it: four times the largest side
// of the box, or what is asked for, whichever is more. Rays that leave a surface start up to 64 e
// of its largest coordinate beside it (shaders/light/leave_surface.glsl), which counts where a
// small scene lies far from zero.
double usual_reach(const Box& bounds, double asked);

// Throws InputError that names the first triangle with a corner that is NaN, infinite or farther
// out than the greatest coordinate that a structure can bear.
void check_corners(std::span<const glm::vec3> corners, float greatest);

// The box with its sides moved outwards by the padding and then to the next number outside, so that
// rounding takes nothing away.
Box pad(const Box& box, double padding);

// The greatest distance along one axis from a point of the box to a corner: what BuildRequest asks
// for. Where rays come from a camera, the box is that of its whole lens (scene/view.h).
float reach_of(const Box& origins, std::span<const glm::vec3> corners);

// The greatest over the origins of all rays.
float reach_of(std::span<const Ray> rays, std::span<const glm::vec3> corners);

} // namespace raysteps
