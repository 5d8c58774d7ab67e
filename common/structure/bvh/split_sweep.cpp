#include "structure/bvh/bvh_split.h"

#include <algorithm>
#include <vector>

namespace raysteps {

namespace {

// An item's place in the range, with what it is sorted by.
struct Ranked {
    float center = 0.0f;
    std::int32_t triangle = 0;
    std::uint32_t place = 0;
};

std::vector<Ranked> ranked_along(int axis, std::span<const BvhItem> items) {
    std::vector<Ranked> ranked(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        ranked[i] = {doubled_center(items[i], axis), items[i].triangle,
                     static_cast<std::uint32_t>(i)};
    }
    std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
        return a.center != b.center ? a.center < b.center : a.triangle < b.triangle;
    });
    return ranked;
}

std::size_t distance_from_middle(std::size_t lower_count, std::size_t all) {
    return lower_count > all - lower_count ? 2 * lower_count - all : all - 2 * lower_count;
}

// The cheapest cut along the axis. The cost is only the sum of areas times numbers here.
BvhCut cheapest_cut(std::span<const BvhItem> items, int axis) {
    const std::vector<Ranked> ranked = ranked_along(axis, items);
    const std::size_t all = items.size();
    std::vector<double> upper_areas(all);
    Box upper;
    for (std::size_t i = all; i-- > 1;) {
        upper = merge(upper, items[ranked[i].place].box);
        upper_areas[i] = surface_area(upper);
    }
    BvhCut best{axis};
    Box lower;
    for (std::size_t count = 1; count < all; ++count) {
        lower = merge(lower, items[ranked[count - 1].place].box);
        const double cost = surface_area(lower) * static_cast<double>(count) +
                            upper_areas[count] * static_cast<double>(all - count);
        const bool nearer_to_middle =
            distance_from_middle(count, all) < distance_from_middle(best.lower_count, all);
        if (cost < best.cost || (cost == best.cost && nearer_to_middle)) {
            best.lower_count = count;
            best.cost = cost;
        }
    }
    return best;
}

} // namespace

std::optional<BvhCut> split_sweep(const BvhRange& range, const BvhOptions& options) {
    std::optional<BvhCut> best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(range.centers.upper[axis] > range.centers.lower[axis])) {
            continue;
        }
        const BvhCut cut = cheapest_cut(range.items, axis);
        if (!best || cut.cost < best->cost) {
            best = cut;
        }
    }
    if (best) {
        best->cost = split_cost(best->cost, range, options);
    }
    return best;
}

} // namespace raysteps
