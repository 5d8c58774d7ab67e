#pragma once

#include "same_bits.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace raysteps {

// Lists of different lengths differ in all they have.
inline std::size_t count_different(std::span<const Hit> a, std::span<const Hit> b) {
    if (a.size() != b.size()) {
        return a.size() + b.size();
    }
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        different += same_bits(a[i], b[i]) ? 0 : 1;
    }
    return different;
}

inline std::size_t count_hits(std::span<const Hit> hits) {
    return static_cast<std::size_t>(std::count_if(
        hits.begin(), hits.end(), [](const Hit& hit) { return hit.triangle != no_triangle; }));
}

} // namespace raysteps
