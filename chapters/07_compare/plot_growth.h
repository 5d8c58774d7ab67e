#pragma once

#include "program/command.h"
#include "growth_lines.h"

#include <span>

namespace raysteps {

// growth_primary.png and so on, one plot a cost, in the folder of --out; none where there is no
// line.
void plot_growth(const Command& command, std::span<const GrowthLine> lines);

} // namespace raysteps
