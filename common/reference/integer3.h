#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace raysteps {

// In units of the smallest float a problem of floats is one of integers, and rationals appear only
// where something is divided.

using Integer = boost::multiprecision::cpp_int;
using Integer3 = std::array<Integer, 3>;

// The float, which is finite, in units of 2^-149, the smallest one: a whole number.
Integer in_units(float value);

inline Integer3 point_in_units(const glm::vec3& point) {
    return {in_units(point.x), in_units(point.y), in_units(point.z)};
}

inline Integer3 difference(const Integer3& a, const Integer3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Integer3 cross(const Integer3& a, const Integer3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Integer dot(const Integer3& a, const Integer3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace raysteps
