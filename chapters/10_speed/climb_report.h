#pragma once

#include "climb.h"
#include "program/output.h"

#include <filesystem>
#include <span>
#include <string>

namespace raysteps {

// For people: a row for each step, with the ratio to the yardstick and its range for each kind of
// rays; below, what a ray costs and does.
std::string to_table(const ClimbedScene& scene, const std::string& yardstick);

// For programs: docs/figures.md.
Numbers to_numbers(std::span<const ClimbedScene> scenes, const ClimbRequest& request);

// The climb as one chart: a field for each kind of rays, a line for each scene, and a mark with its
// range for each step. Throws as run_gnuplot does (image/plot.h).
void draw_climb(const std::filesystem::path& png, std::span<const ClimbedScene> scenes,
                const std::string& yardstick);

// The part of the lanes that is at work, step by step and kind by kind: bars. Throws so too.
void draw_lanes(const std::filesystem::path& png, const ClimbedScene& scene);

} // namespace raysteps
