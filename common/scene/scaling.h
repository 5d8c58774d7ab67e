#pragma once

#include "basics/ray.h"
#include "scene/scene.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <limits>
#include <string>
#include <vector>

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

// A float has 24 binary digits: of a house in map coordinates they leave none for a door. So
// coordinates are read in double, and a point near the model becomes the origin.

// A box in double; empty where nothing was added.
struct DoubleBox {
    glm::dvec3 lower{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper{-std::numeric_limits<double>::infinity()};
};

inline void extend(DoubleBox& box, const glm::dvec3& point) {
    box.lower = glm::min(box.lower, point);
    box.upper = glm::max(box.upper, point);
}

// What to take from every coordinate of a model in that box: zero, as long as it is at most 16
// times its largest side from the origin, where it loses at most four digits; else a point near
// its middle, which is a multiple of a power of two, as large as a quarter of that side or more. So
// it is a whole number where the model is larger than 4, and floats of the file stay exact.
glm::dvec3 offset_of(const DoubleBox& box);

// A point of the scene as the float from which, with the origin, the same point is read again.
glm::vec3 as_seen_from(const glm::dvec3& origin, const glm::dvec3& point);

// The camera at the other end of the offset; to be read only, where that is far.
Camera moved(Camera camera, const glm::dvec3& offset);

// Sentences on what was taken from the coordinates, and where floats leave few digits for the
// smallest edge: "a float has 5.2 bits left for it".
std::vector<std::string> tell_precision(const Scene& scene);

// A sentence with the remedy where the scene is so small that the shares of its triangles are not
// computed exactly; empty where it is not.
std::string warn_of_size(const Scene& scene);

} // namespace raysteps
