#pragma once

#include "hard_cases/meshes.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/bvh.h"
#include "structure/bvh/bvh_split.h"
#include "structure/bvh/check_bvh.h"

#include <algorithm>
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
    options.traversal_cost = 1.0; // the trees and the ratios of these tests are for such costs
    options.leaf_triangles = 4;
    return options;
}

// A cube of side 1 whose lower corner is there.
inline BvhItem cube_at(float x, float y, float z, int triangle) {
    return {{{x, y, z}, {x + 1.0f, y + 1.0f, z + 1.0f}}, triangle};
}

inline BvhRange range_of(std::span<const BvhItem> items) {
    BvhRange range{items, {}, {}};
    for (const BvhItem& item : items) {
        range.box = merge(range.box, item.box);
        range.centers = merge(range.centers, doubled_center(item));
    }
    return range;
}

inline std::string first_fault(const Bvh& bvh, std::span<const glm::vec3> corners) {
    const std::vector<std::string> faults = check_bvh(bvh, corners);
    return faults.empty() ? "" : faults.front();
}

inline bool same_tree(const Bvh& a, const Bvh& b) {
    const auto same_node = [](const BvhNode& left, const BvhNode& right) {
        return left.first == right.first && left.count == right.count &&
               left.box.lower == right.box.lower && left.box.upper == right.box.upper;
    };
    return a.order == b.order &&
           std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), same_node);
}

// Levels that it takes to halve so many triangles until leaves have room for them.
inline int levels_of_halving(std::size_t triangles, const BvhOptions& options) {
    return static_cast<int>(
        std::ceil(std::log2(std::ceil(static_cast<double>(triangles) / options.leaf_triangles))));
}

inline std::vector<glm::vec3> random_corners(int seed, int triangles) {
    RandomNumbers numbers(seed);
    return random_triangles(numbers, triangles).corners;
}

} // namespace raysteps
