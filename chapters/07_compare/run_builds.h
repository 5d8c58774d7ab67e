#pragma once

#include "run_comparison.h"

namespace raysteps {

// Builds a BVH of each scene in turn with Embree, prints the table, and writes builds.csv to the
// folder of --out.
void run_builds(const Command& command, const Comparison& comparison);

} // namespace raysteps
