#include "basics/statistics.h"

#include "basics/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace raysteps {

Summary summarize(std::span<const float> values) {
    assert(!values.empty());
    std::vector<float> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    // The value that at least this part of all do not exceed (nearest rank).
    const auto at_part = [&](std::size_t hundredths) {
        const std::size_t rank = (sorted.size() * hundredths + 99) / 100;
        return static_cast<double>(sorted[std::max<std::size_t>(rank, 1) - 1]);
    };
    return {at_part(50), at_part(99), static_cast<double>(sorted.back())};
}

std::string to_string(const Summary& summary) {
    return fmt::format("median {:.3g}, 99 % up to {:.3g}, largest {:.3g}", summary.median,
                       summary.percentile_99, summary.largest);
}

MeasuredRange measured_range(std::vector<double> values) {
    //# exercise 7.1: the median and the range
    std::sort(values.begin(), values.end());
    return {values[values.size() / 2], values.front(), values.back()};
    //# stub: return {values.front(), values.front(), values.front()};
    //# end
}

bool lies_below(const MeasuredRange& a, const MeasuredRange& b) {
    //# exercise 7.2: is one surely less
    return a.highest < b.lowest;
    //# stub: return a.median < b.median;
    //# end
}

double growth_exponent(std::span<const GrowthPoint> points) {
    for (const GrowthPoint& point : points) {
        if (!(point.triangles > 0.0 && point.cost > 0.0)) {
            throw InputError("a growth exponent needs numbers over 0. Leave out empty scenes.");
        }
    }
    //# exercise 7.3: how a cost grows
    const double count = static_cast<double>(points.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (const GrowthPoint& point : points) {
        mean_x += std::log(point.triangles) / count;
        mean_y += std::log(point.cost) / count;
    }
    double squares = 0.0;
    double products = 0.0;
    for (const GrowthPoint& point : points) {
        const double x = std::log(point.triangles) - mean_x;
        squares += x * x;
        products += x * (std::log(point.cost) - mean_y);
    }
    //# stub: const double squares = 1.0;
    //# stub: const double products = 0.0;
    //# end
    // A sum of rounding errors is no spread: numbers of triangles are whole, and the logarithms of
    // two different ones below 2^31 lie 4e-10 apart.
    if (!(squares > 1e-20)) {
        throw InputError("a growth exponent needs two scenes of different numbers of triangles. "
                         "Add a scene.");
    }
    return products / squares;
}

} // namespace raysteps
