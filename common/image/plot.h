#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace raysteps {

// In quotes, for gnuplot and for the shell alike: neither looks into '...' until the next mark.
// Texts lose such marks; paths with one are refused.
std::string gnuplot_text(const std::string& text);

// Runs the script, which draws to the PNG file. It stays beside it as NAME.gp, so that anybody can
// draw it another way. Throws MachineError where gnuplot is missing or refuses, InputError where a
// file cannot be written.
void run_gnuplot(const std::filesystem::path& png, const std::string& script_text);

struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

// A line with a mark at each point, in the order given.
struct PlotLine {
    std::string name;
    std::vector<PlotPoint> points;
};

enum class PlotScale { linear, logarithmic };

struct Plot {
    std::string title;
    std::string x_label; // with the unit
    std::string y_label;
    PlotScale x_scale = PlotScale::linear;
    PlotScale y_scale = PlotScale::linear;
    std::vector<PlotLine> lines;
};

// Draws the plot to the PNG file, by gnuplot. The script with the numbers stays beside it, as
// NAME.gp, so that anybody can draw it another way. Throws MachineError where gnuplot is missing or
// refuses, InputError where a file cannot be written.
void write_plot(const std::filesystem::path& png, const Plot& plot);

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
