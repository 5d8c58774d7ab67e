#pragma once

#include "basics/statistics.h"
#include "measure/scene_costs.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// How one cost of one contender grows over the scenes of a series.
struct GrowthLine {
    std::string contender;
    std::string cost; // `primary` and so on: nanoseconds per ray; build_seconds; memory_bytes
    std::vector<GrowthPoint> points; // in the order of the scenes
    double exponent = 0.0;
};

// For each contender and each cost that was measured for two sizes or more, of the results whose
// scene's name begins with `series:`.
std::vector<GrowthLine> growth_lines(std::span<const SceneCosts> results,
                                     const std::string& series);

// For people.
std::string to_table(std::span<const GrowthLine> lines);

// growth_primary.png and so on in the folder, one plot per cost; none where there is no line.
void plot_growth(const std::filesystem::path& folder, std::span<const GrowthLine> lines);

} // namespace raysteps
