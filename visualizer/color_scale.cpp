#include "color_scale.h"

#include "cell_choice.h"
#include "image/color.h"
#include "stage.h"
#include "visualizer/replay/sentence.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace raysteps::view {

namespace {

// A cell without a surface is never met. The logarithm of nothing has no colour: such cells get
// that of the cheapest.
constexpr double least_cost = 1e-12;

} // namespace

glm::vec3 color_in(const ValueRange& range, double value) {
    const double part = std::clamp((value - range.lower) / (range.upper - range.lower), 0.0, 1.0);
    // The brightest yellow is hard to see on paper.
    const glm::vec3 linear = color_map(static_cast<float>(0.92 * part));
    return {srgb_from_linear(linear.x), srgb_from_linear(linear.y), srgb_from_linear(linear.z)};
}

std::string color_title(CellColor color) {
    switch (color) {
    case CellColor::depth:
        return "depth in the tree";
    case CellColor::triangles:
        return "triangles in the cell";
    case CellColor::cost:
        return "expected cost, logarithmic";
    case CellColor::visits:
        break;
    }
    return "visits by this ray";
}

std::vector<double> color_values(const Pane& pane, const State& state,
                                 const std::vector<int>& cells) {
    const bool by_visits = state.color == CellColor::visits;
    const std::vector<int> visits = by_visits ? visits_of(pane, state) : std::vector<int>{};
    std::vector<double> values;
    values.reserve(cells.size());
    for (const int number : cells) {
        const auto place = static_cast<std::size_t>(number);
        const Cell& cell = pane.cells.cells[place];
        switch (state.color) {
        case CellColor::depth:
            values.push_back(cell.depth);
            break;
        case CellColor::triangles:
            values.push_back(cell.triangles);
            break;
        case CellColor::cost:
            values.push_back(std::log10(std::max(cell.cost, least_cost)));
            break;
        case CellColor::visits:
            values.push_back(visits.empty() ? 0.0 : visits[place]);
            break;
        }
    }
    return values;
}

ValueRange color_range(const Stage& stage, const State& state) {
    std::vector<double> values;
    for (const std::unique_ptr<Pane>& pane : stage.panes()) {
        if (state.color == CellColor::depth) {
            values.insert(values.end(), {0.0, static_cast<double>(pane->cells.deepest)});
            continue;
        }
        const std::vector<double> own =
            color_values(*pane, state, choose_cells(*pane, state).cells);
        std::copy_if(own.begin(), own.end(), std::back_inserter(values), [&](double value) {
            return state.color != CellColor::cost || value > std::log10(least_cost);
        });
    }
    if (values.empty()) {
        return {};
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *least < *most ? ValueRange{*least, *most} : ValueRange{*least, *least + 1.0};
}

double number_of(CellColor color, double value) {
    return color == CellColor::cost ? std::pow(10.0, value) : value;
}

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

ValueRange heat_range(const Stage& stage, const State& state, std::size_t pane) {
    if (state.own_scales) {
        return {0.0, heat_limit(heat_values(*stage.panes()[pane], state.heat_map))};
    }
    ValueRange range{0.0, 1.0};
    for (const std::unique_ptr<Pane>& each : stage.panes()) {
        range.upper = std::max(range.upper, heat_limit(heat_values(*each, state.heat_map)));
    }
    return range;
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
