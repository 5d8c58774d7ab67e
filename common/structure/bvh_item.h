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

// The surface of the box; 0 where it is empty. In double, since the product of two sides of 1e30 is
// no float any more.
inline double surface_area(const Box& box) {
    if (is_empty(box)) {
        return 0.0;
    }
    const double x = static_cast<double>(box.upper.x) - static_cast<double>(box.lower.x);
    const double y = static_cast<double>(box.upper.y) - static_cast<double>(box.lower.y);
    const double z = static_cast<double>(box.upper.z) - static_cast<double>(box.lower.z);
    return 2.0 * (x * y + y * z + z * x);
}

} // namespace raysteps
