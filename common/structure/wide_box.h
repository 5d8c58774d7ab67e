#pragma once

#include "geometry/box.h"

#include <array>
#include <cstddef>
#include <limits>

namespace raysteps {

// A box with a fourth axis that nobody asks for: compilers merge four numbers in one instruction,
// and three in three. Builders spend most of their time on it.
struct alignas(16) WideBox {
    std::array<float, 4> lower;
    std::array<float, 4> upper;
};

inline WideBox empty_wide_box() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {{+infinity, +infinity, +infinity, +infinity},
            {-infinity, -infinity, -infinity, -infinity}};
}

inline WideBox widen(const Box& box) {
    return {{box.lower.x, box.lower.y, box.lower.z, 0.0f},
            {box.upper.x, box.upper.y, box.upper.z, 0.0f}};
}

inline Box narrow(const WideBox& box) {
    return {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
}

inline WideBox merge(const WideBox& a, const WideBox& b) {
    WideBox both; // every number is set below
    for (std::size_t axis = 0; axis < 4; ++axis) {
        both.lower[axis] = b.lower[axis] < a.lower[axis] ? b.lower[axis] : a.lower[axis];
    }
    for (std::size_t axis = 0; axis < 4; ++axis) {
        both.upper[axis] = b.upper[axis] > a.upper[axis] ? b.upper[axis] : a.upper[axis];
    }
    return both;
}

} // namespace raysteps
