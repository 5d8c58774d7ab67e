#pragma once

#include <string>
#include <vector>

namespace raysteps {

// One of several choices, with its range along both axes. Where y is 0, only its upper bound is
// drawn: a logarithm has no place for 0.
struct ScatterPoint {
    std::string label;
    std::string hint; // shown where a pointer rests on it
    double x = 0.0;
    double x_lowest = 0.0;
    double x_highest = 0.0;
    double y = 0.0;
    double y_lowest = 0.0;
    double y_highest = 0.0;
    bool dominated = false; // another is better in one way and worse in none
};

struct ScatterPlot {
    std::string title;
    std::string x_label; // with the unit
    std::string y_label;
    std::vector<ScatterPoint> points;
};

// The plot as an SVG element, both axes logarithmic. Labels stand in a column on the right, each
// with a line to its point. Values along x are over 0; of y, the upper bounds are.
std::string to_svg(const ScatterPlot& plot);

// The text with the signs that HTML and SVG keep for themselves written out.
std::string escaped(const std::string& text);

} // namespace raysteps
