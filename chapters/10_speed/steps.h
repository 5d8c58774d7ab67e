#pragma once

#include "measure/ray_kinds.h"

#include <string>
#include <vector>

namespace raysteps {

// One idea on the way from the first walk of chapter 06 to the last: how a list of rays lies, and
// which walk traces it.
struct SpeedStep {
    std::string name;
    std::string structure;
    ListLayout layout = ListLayout::blocks;
};

// Each differs from the one before by one idea.
std::vector<SpeedStep> speed_steps();

// Whether rays of that kind take the step. Packets are for neighbours: others stay where they are.
bool takes(const RayKind& kind, const SpeedStep& step);

} // namespace raysteps
