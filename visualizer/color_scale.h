#pragma once

#include "pane.h"

#include <cstddef>
#include <string>
#include <vector>

// What colours show: values of cells, and of pixels in a heat map.
namespace raysteps::view {

class Stage;

// The values of the first and the last colour.
struct ValueRange {
    double lower = 0.0;
    double upper = 1.0;
};

// The sRGB colour of a value in its range.
glm::vec3 color_in(const ValueRange& range, double value);

std::string color_title(CellColor color);

// The value that gives each of these cells its colour: its depth, triangles or visits, or the
// logarithm to base 10 of its cost, since a few cells near the root cost more than all others
// together.
std::vector<double> color_values(const Pane& pane, const State& state,
                                 const std::vector<int>& cells);

// The same range for all panes: all depths there are, or the values of the cells that are drawn.
ValueRange color_range(const Stage& stage, const State& state);

// What a value of a colour stands for: of a logarithm, its number.
double number_of(CellColor color, double value);

// The value of each pixel in the heat map, row by row from the top.
std::vector<float> heat_values(const Pane& pane, HeatMap map);

// The value of the last colour: 99 % of the pixels that cost anything stay below it. A few rays
// along a silhouette cost many times more, and would leave the rest in the dark.
double heat_limit(const std::vector<float>& values);

// The same scale for the heat maps of all panes, so that the brightest does most; or, where the
// state asks for it, this pane's own.
ValueRange heat_range(const Stage& stage, const State& state, std::size_t pane);

// `visits a pixel: 17.2 on average, 213 at most`, and the state's pixel, where there is one.
std::string heat_title(const Pane& pane, const State& state);

// How many values fall into each of so many equal parts from 0 to the limit; those beyond it count
// in the last part.
std::vector<std::size_t> histogram_of(const std::vector<float>& values, double limit, int parts);

} // namespace raysteps::view
