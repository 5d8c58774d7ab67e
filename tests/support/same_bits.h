#pragma once

#include "basics/ray.h"

#include <bit>
#include <cstdint>

namespace raysteps {

inline bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

inline bool same_bits(const glm::vec3& a, const glm::vec3& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

inline bool same_bits(const Ray& a, const Ray& b) {
    return same_bits(a.origin, b.origin) && same_bits(a.direction, b.direction) &&
           same_bits(a.t_min, b.t_min) && same_bits(a.t_max, b.t_max);
}

// Of a miss, u and v mean nothing.
inline bool same_bits(const Hit& a, const Hit& b) {
    return a.triangle == b.triangle && same_bits(a.t, b.t) &&
           (a.triangle < 0 || (same_bits(a.u, b.u) && same_bits(a.v, b.v)));
}

} // namespace raysteps
