#pragma once

#include "measure/contest.h"
#include "measure/statistics.h"

#include <span>
#include <string>
#include <vector>

namespace raysteps {

// How one cost of one contender grows over the scenes of a series.
struct GrowthLine {
    std::string contender;
    std::string cost; // `primary` and so on: nanoseconds a ray; build_seconds; memory_bytes
    std::vector<GrowthPoint> points; // in the order of the scenes
    double exponent = 0.0;
};

// Of the results whose scene's name begins with `series:`, each contender and each cost that two
// sizes at least have.
std::vector<GrowthLine> growth_lines(std::span<const SceneResult> results,
                                     const std::string& series);

// For people.
std::string to_table(std::span<const GrowthLine> lines);

} // namespace raysteps
