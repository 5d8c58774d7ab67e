#include "structure/split_binned.h"

#include <algorithm>
#include <vector>

namespace raysteps {

namespace {

struct Bin {
    Box box;
    std::size_t count = 0;
};

// Which bin a centre falls into. It never falls as the centre rises, since rounded differences and
// products do not: so the bins below a plane hold the first items in the order of the centres.
struct BinScale {
    double lower = 0.0;
    double bins_a_unit = 0.0;
    int last = 0;
};

int bin_of(const BinScale& scale, float center) {
    const double place = (static_cast<double>(center) - scale.lower) * scale.bins_a_unit;
    return std::min(scale.last, static_cast<int>(place));
}

std::vector<Bin> fill_bins(std::span<const BvhItem> items, int axis, const BinScale& scale) {
    std::vector<Bin> bins(static_cast<std::size_t>(scale.last) + 1);
    for (const BvhItem& item : items) {
        Bin& bin = bins[static_cast<std::size_t>(bin_of(scale, doubled_center(item, axis)))];
        bin.box = merge(bin.box, item.box);
        ++bin.count;
    }
    return bins;
}

// More bins than items make little difference, and near the leaves they take most of the time.
int bins_for(std::size_t items, const BvhOptions& options) {
    const auto bins = static_cast<std::size_t>(options.bins);
    return static_cast<int>(std::min(bins, items + 4));
}

// The cheapest cut between two of the bins. The cost is only the sum of areas times numbers here.
BvhCut cheapest_cut(std::span<const Bin> bins, int axis, std::size_t all) {
    std::vector<double> upper_areas(bins.size());
    Box upper;
    for (std::size_t i = bins.size(); i-- > 1;) {
        upper = merge(upper, bins[i].box);
        upper_areas[i] = surface_area(upper);
    }
    BvhCut best{axis};
    Box lower;
    std::size_t count = 0;
    for (std::size_t i = 1; i < bins.size(); ++i) {
        lower = merge(lower, bins[i - 1].box);
        count += bins[i - 1].count;
        //# exercise 6.6: what a cut costs
        const double cost = surface_area(lower) * static_cast<double>(count) +
                            upper_areas[i] * static_cast<double>(all - count);
        //# stub: const double cost = static_cast<double>(all + count + i);
        //# end
        if (cost < best.cost) {
            best.lower_count = count;
            best.cost = cost;
        }
    }
    return best;
}

} // namespace

std::optional<BvhCut> split_binned(const BvhRange& range, const BvhOptions& options) {
    const int bins = bins_for(range.items.size(), options);
    std::optional<BvhCut> best;
    for (int axis = 0; axis < 3; ++axis) {
        const auto lower = static_cast<double>(range.centers.lower[axis]);
        const double extent = static_cast<double>(range.centers.upper[axis]) - lower;
        if (!(extent > 0.0)) {
            continue;
        }
        // The first and the last bin hold an item each, so no plane leaves a side empty.
        const BinScale scale{lower, bins / extent, bins - 1};
        const BvhCut cut =
            cheapest_cut(fill_bins(range.items, axis, scale), axis, range.items.size());
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
