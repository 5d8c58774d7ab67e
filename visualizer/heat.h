#pragma once

#include "stage.h"

#include <cstddef>
#include <string>
#include <vector>

namespace raysteps::view {

// What the heat map shows of each pixel, row by row from the top.
std::vector<float> heat_values(const Pane& pane, HeatMap map);

// The value of the last colour: what 99 in 100 of the pixels that cost anything stay below. A few
// rays along a silhouette do many times more, and would leave the rest in the dark.
double heat_limit(const std::vector<float>& values);

// `visits a pixel, 17.2 on average, 213 at most`, and the state's pixel, where there is one.
std::string heat_title(const Pane& pane, const State& state);

// How many values there are in each of so many equal parts from 0 to the limit; those beyond are in
// the last one.
std::vector<std::size_t> histogram_of(const std::vector<float>& values, double limit, int parts);

} // namespace raysteps::view
