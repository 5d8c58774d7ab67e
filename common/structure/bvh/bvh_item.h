#pragma once

#include "geometry/box.h"

#include <cstdint>

namespace raysteps {

// A triangle as a builder sees it: its box, padded, and its number.
struct BvhItem {
    Box box;
    std::int32_t triangle = 0;
};

// Twice the centre of the item's box along the axis. Only the order of centres matters, and that of
// their doubles is the same.
inline float doubled_center(const BvhItem& item, int axis) {
    return item.box.lower[axis] + item.box.upper[axis];
}

inline glm::vec3 doubled_center(const BvhItem& item) {
    return item.box.lower + item.box.upper;
}

// The surface of a box that is not empty, from its corners of three numbers or more. In double,
// since the product of two sides of 1e30 is no float any more.
template <class Corner>
double surface_between(const Corner& lower, const Corner& upper) {
    const double x = static_cast<double>(upper[0]) - static_cast<double>(lower[0]);
    const double y = static_cast<double>(upper[1]) - static_cast<double>(lower[1]);
    const double z = static_cast<double>(upper[2]) - static_cast<double>(lower[2]);
    return 2.0 * (x * y + y * z + z * x);
}

// The surface of the box; 0 where it is empty.
inline double surface_area(const Box& box) {
    return is_empty(box) ? 0.0 : surface_between(box.lower, box.upper);
}

} // namespace raysteps
