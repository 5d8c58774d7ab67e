#pragma once

#include "structure/build_bvh.h"
#include "structure/check_bvh.h"
#include "structure/measure_bvh.h"
#include "support/soup.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace raysteps {

inline constexpr std::array all_splits{BvhSplit::median, BvhSplit::insertion, BvhSplit::binned,
                                       BvhSplit::sweep};

inline BvhOptions with_split(BvhSplit split) {
    BvhOptions options;
    options.split = split;
    return options;
}

inline std::string first_fault(const Bvh& bvh, std::span<const glm::vec3> corners) {
    const std::vector<std::string> faults = check_bvh(bvh, corners);
    return faults.empty() ? "" : faults.front();
}

// Levels that it takes to halve so many triangles until leaves have room for them.
inline int levels_of_halving(std::size_t triangles, const BvhOptions& options) {
    return static_cast<int>(
        std::ceil(std::log2(std::ceil(static_cast<double>(triangles) / options.leaf_triangles))));
}

// Triangles whose boxes have the sides 2 a and the middle `center`, but for rounding.
inline std::vector<glm::vec3> triangle_around(const glm::vec3& center, const glm::vec3& a) {
    return {center - a, center + a, center + glm::vec3(a.x, -a.y, a.z)};
}

inline std::vector<glm::vec3> random_corners(int seed, int triangles) {
    RandomNumbers numbers(seed);
    return random_triangles(numbers, triangles).corners;
}

} // namespace raysteps
