#pragma once

#include "structure/bvh_item.h"

#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>

namespace raysteps {

// Four numbers that one instruction computes with (g++ and clang++ have such types).
using FourFloats = float __attribute__((vector_size(16)));

// A box with a fourth axis that nobody asks for. Builders spend most of their time merging boxes,
// and four axes at once are merged sooner than three one by one.
struct WideBox {
    FourFloats lower;
    FourFloats upper;
};

inline WideBox empty_wide_box() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {FourFloats{+infinity, +infinity, +infinity, +infinity},
            FourFloats{-infinity, -infinity, -infinity, -infinity}};
}

// The box of an item; on the fourth axis stands what comes next in memory.
inline WideBox wide_box_of(const BvhItem& item) {
    static_assert(std::is_trivially_copyable_v<BvhItem> && sizeof(Box) == 6 * sizeof(float) &&
                  sizeof(BvhItem) == 7 * sizeof(float));
    const auto* const bytes = reinterpret_cast<const std::byte*>(&item);
    WideBox box; // every number is set
    std::memcpy(&box.lower, bytes, sizeof(box.lower));
    std::memcpy(&box.upper, bytes + sizeof(glm::vec3), sizeof(box.upper));
    return box;
}

inline Box narrow(const WideBox& box) {
    return {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
}

inline WideBox merge(const WideBox& a, const WideBox& b) {
    return {b.lower < a.lower ? b.lower : a.lower, b.upper > a.upper ? b.upper : a.upper};
}

// Twice the centre: see doubled_center.
inline FourFloats doubled_center(const WideBox& box) {
    return box.lower + box.upper;
}

// The surface of a box that is not empty.
inline double surface_area(const WideBox& box) {
    return surface_between(box.lower, box.upper);
}

} // namespace raysteps
