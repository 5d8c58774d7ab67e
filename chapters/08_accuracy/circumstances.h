#pragma once

#include "effort.h"
#include "run_knob.h"

#include <string>
#include <utility>
#include <vector>

namespace raysteps {

// The processor time of the process where OpenGL runs on the processor, else the clock on the wall.
Clock clock_of_renderer();

// What somebody needs to know to measure again: date, renderer, clock, compiler and its flags, the
// commit of the source, seed, rounds and rays. A context must be current.
std::vector<std::pair<std::string, std::string>> circumstances_of(const Effort& effort);

} // namespace raysteps
