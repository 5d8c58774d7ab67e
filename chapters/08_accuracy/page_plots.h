#pragma once

#include "knob.h"

#include <string>

namespace raysteps {

// Faults against time, and error against time, each method once (08_accuracy/verdict.h): two SVG
// elements, or those that there are numbers for. Of knobs that change only the speed, none.
std::string plots_of(const KnobResult& result);

} // namespace raysteps
