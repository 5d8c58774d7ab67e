#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace raysteps {

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

} // namespace raysteps
