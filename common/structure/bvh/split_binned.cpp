#include "structure/bvh/bvh_split.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace raysteps {

namespace {

struct Bin {
    WideBox box = empty_wide_box();
    float first_center = std::numeric_limits<float>::infinity(); // doubled
    std::uint32_t count = 0;
    double area_from_here = 0.0; // around this bin and all above it
};

// Which bin a centre falls into. It never falls as the centre rises, since rounded differences and
// products do not: so the bins below a plane hold the first items in the order of the centres.
struct BinScale {
    double lower = 0.0;
    double bins_a_unit = 0.0; // 0 where all centres are equal
    int last = 0;
};

std::size_t bin_of(const BinScale& scale, float center) {
    const double place = (static_cast<double>(center) - scale.lower) * scale.bins_a_unit;
    return static_cast<std::size_t>(std::min(scale.last, static_cast<int>(place)));
}

std::array<BinScale, 3> scales_of(const Box& centers, int bins) {
    std::array<BinScale, 3> scales;
    for (int axis = 0; axis < 3; ++axis) {
        const auto lower = static_cast<double>(centers.lower[axis]);
        const double extent = static_cast<double>(centers.upper[axis]) - lower;
        scales[static_cast<std::size_t>(axis)] = {lower, extent > 0.0 ? bins / extent : 0.0,
                                                  bins - 1};
    }
    return scales;
}

// The bins of the three axes, one axis behind the other. All are filled in one go, since it is
// fetching the items that takes time.
std::vector<Bin> fill_bins(std::span<const BvhItem> items, const std::array<BinScale, 3>& scales) {
    const auto bins_an_axis = static_cast<std::size_t>(scales[0].last) + 1;
    std::vector<Bin> bins(3 * bins_an_axis);
    for (const BvhItem& item : items) {
        const WideBox box = wide_box_of(item);
        const FourFloats center = doubled_center(box);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Bin& bin = bins[axis * bins_an_axis + bin_of(scales[axis], center[axis])];
            bin.box = merge(bin.box, box);
            bin.first_center = std::min(bin.first_center, center[axis]);
            ++bin.count;
        }
    }
    return bins;
}

// More bins than items make little difference, and near the leaves they take most of the time.
int bins_for(std::size_t items, const BvhOptions& options) {
    const auto bins = static_cast<std::size_t>(options.bins);
    return static_cast<int>(std::min(bins, items + 4));
}

// Those that hold an item, in their order. A cut beside an empty bin is also one between these.
std::span<Bin> filled(std::span<Bin> bins) {
    const auto end =
        std::remove_if(bins.begin(), bins.end(), [](const Bin& bin) { return bin.count == 0; });
    return {bins.begin(), end};
}

// The cheapest cut between two of the bins. The cost is only the sum of areas times numbers here.
// The first and the last bin hold an item each, so no cut leaves a side empty, and no box is.
BvhCut cheapest_cut(std::span<Bin> bins, int axis, std::size_t all) {
    WideBox upper = empty_wide_box();
    for (std::size_t i = bins.size(); i-- > 1;) {
        upper = merge(upper, bins[i].box);
        bins[i].area_from_here = surface_area(upper);
    }
    BvhCut best{axis};
    std::size_t best_bin = 0;
    WideBox lower = empty_wide_box();
    std::size_t count = 0;
    for (std::size_t i = 1; i < bins.size(); ++i) {
        lower = merge(lower, bins[i - 1].box);
        count += bins[i - 1].count;
        //# exercise 6.6: what a cut costs
        const double cost = surface_area(lower) * static_cast<double>(count) +
                            bins[i].area_from_here * static_cast<double>(all - count);
        //# stub: const double cost = static_cast<double>(all + count + i);
        //# end
        if (cost < best.cost) {
            best.lower_count = count;
            best.cost = cost;
            best_bin = i;
        }
    }
    float first_upper_center = std::numeric_limits<float>::infinity();
    for (const Bin& bin : bins.subspan(best_bin)) {
        first_upper_center = std::min(first_upper_center, bin.first_center);
    }
    best.first_upper_center = first_upper_center;
    return best;
}

} // namespace

std::optional<BvhCut> split_binned(const BvhRange& range, const BvhOptions& options) {
    const std::array<BinScale, 3> scales =
        scales_of(range.centers, bins_for(range.items.size(), options));
    std::vector<Bin> bins = fill_bins(range.items, scales);
    const std::size_t bins_an_axis = bins.size() / 3;
    std::optional<BvhCut> best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (scales[axis].bins_a_unit == 0.0) {
            continue;
        }
        const std::span<Bin> all = std::span(bins).subspan(axis * bins_an_axis, bins_an_axis);
        const BvhCut cut = cheapest_cut(filled(all), static_cast<int>(axis), range.items.size());
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
