#pragma once

#include "basics/ray.h"
#include "scene/scene.h"

#include <string>

namespace raysteps {

// A scene whose lengths are multiplied by a power of two is the same scene: as long as nothing
// overflows or underflows, every difference, product and comparison gives the same digits. A ray
// that is scaled with it finds the same triangle at the same t, u and v. So a scene that is too
// small for the numbers at hand (docs/numerics.md) is traced at a size where they suffice.

// Scale factors are 2^-60 to 2^60: a scene file can hold them as the scale of a model.
inline constexpr int greatest_scale_exponent = 60;

Camera scaled(Camera camera, int exponent);
Light scaled(Light light, int exponent);

// Absorption is by length: what a unit of length keeps of the light, 2^exponent units keep now.
Material scaled(Material material, int exponent);

// Throws InputError where a number of the ray is too large for a float then.
Ray scaled(const Ray& ray, int exponent);

// A sentence with the remedy where the scene is so small that the shares of its triangles are not
// computed exactly; empty where it is not.
std::string warn_of_size(const Scene& scene);

} // namespace raysteps
