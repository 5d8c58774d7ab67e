#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace raysteps {

// One kind of bars: a value for each label of the chart, in their order; NaN where there is none.
struct BarSeries {
    std::string name;
    std::vector<double> values;
};

struct BarChart {
    std::string title;
    std::string y_label; // with the unit
    std::vector<std::string> labels;
    std::vector<BarSeries> series; // side by side at each label
};

// Draws the chart to the PNG file, by gnuplot. Throws as run_gnuplot does.
void write_bar_chart(const std::filesystem::path& png, const BarChart& chart);

} // namespace raysteps
