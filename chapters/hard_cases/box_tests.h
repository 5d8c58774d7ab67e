#pragma once

#include "basics/box.h"
#include "basics/ray.h"

namespace raysteps {

// Whether the box tests of the walks through a BVH visit the box, which nobody has padded: as C++,
// by the shader parts structure/bvh/box_ray.glsl and box_padded.glsl.
bool meets_plain_box(const Ray& ray, const Box& box);
bool meets_padded_box(const Ray& ray, const Box& box);

// The box with nine roundings more on every side, for numbers up to 4: what the plain test needs
// (structure/bvh/box_ray.glsl has the derivation).
Box grown_by_roundings(const Box& box);

} // namespace raysteps
