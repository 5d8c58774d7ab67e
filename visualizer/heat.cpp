#include "heat.h"

#include "visualizer/replay/sentence.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace raysteps::view {

std::vector<float> heat_values(const Pane& pane, HeatMap map) {
    std::vector<float> values;
    values.reserve(pane.counted.size());
    for (const WalkCount& count : pane.counted) {
        values.push_back(static_cast<float>(map == HeatMap::tests ? count.tests : count.visits));
    }
    return values;
}

double heat_limit(const std::vector<float>& values) {
    std::vector<float> some;
    std::copy_if(values.begin(), values.end(), std::back_inserter(some),
                 [](float value) { return value > 0.0f; });
    if (some.empty()) {
        return 1.0;
    }
    const std::size_t place = (some.size() - 1) * 99 / 100;
    std::nth_element(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(place), some.end());
    return static_cast<double>(some[place]);
}

std::string heat_title(const Pane& pane, const State& state) {
    const std::vector<float> values = heat_values(pane, state.heat_map);
    if (values.empty()) {
        return "";
    }
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    const std::string what = state.heat_map == HeatMap::tests ? "tests" : "visits";
    std::string title =
        what + " a pixel: " + short_number(sum / static_cast<double>(values.size())) +
        " on average, " +
        short_number(static_cast<double>(*std::max_element(values.begin(), values.end()))) +
        " at most";
    if (state.pixel) {
        const auto place =
            static_cast<std::size_t>(state.pixel->y * state.picture.x + state.pixel->x);
        title += ", here " + short_number(static_cast<double>(values[place]));
    }
    return title;
}

std::vector<std::size_t> histogram_of(const std::vector<float>& values, double limit, int parts) {
    std::vector<std::size_t> counts(static_cast<std::size_t>(parts), 0);
    for (const float value : values) {
        const int part = static_cast<int>(static_cast<double>(value) / limit * parts);
        ++counts[static_cast<std::size_t>(std::clamp(part, 0, parts - 1))];
    }
    return counts;
}

} // namespace raysteps::view
