#pragma once

#include "recorded_walk.h"

#include <cstddef>
#include <string>

namespace raysteps {

// What a step did, as a sentence without a stop: "step 7: cell (3,0,5), t 1.25 to 1.31, leaves
// through +x, 2 triangles tested, no hit". Steps count from 1.
std::string sentence_of(const StructureCells& structure, const RecordedWalk& walk,
                        std::size_t step);

// Why the walk ended, and with what: "no nearer hit can come: triangle 88 at t 1.27".
std::string ending_of(const RecordedWalk& walk);

// `0.25`, `1.2e+09`: four digits.
std::string short_number(double value);

// "1 triangle", "2 triangles".
std::string count_of(std::size_t count, const std::string& thing);

} // namespace raysteps
