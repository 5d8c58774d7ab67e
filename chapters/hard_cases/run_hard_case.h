#pragma once

#include "trial.h"

namespace raysteps {

// Traces the case's rays by every structure with the watertight test, and where the case is about
// them, by every triangle test in the loop over every triangle; as C++ and on the GPU, as the tools
// say. A row for each. Structures are promised to find the bits of the loop; the watertight test,
// what the case says. Everything else is reported.
std::vector<TrialRow> run_hard_case(const HardCase& hard_case, const TrialTools& tools);

} // namespace raysteps
