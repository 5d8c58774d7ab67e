#include "report/summary.h"

#include <algorithm>
#include <cassert>
#include <cstdio>
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
    char text[96];
    std::snprintf(text, sizeof text, "median %.3g, 99 %% up to %.3g, largest %.3g", summary.median,
                  summary.percentile_99, summary.largest);
    return text;
}

} // namespace raysteps
