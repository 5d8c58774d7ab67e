#pragma once

#include "knob.h"

#include <span>
#include <string>

namespace raysteps {

// For people: one line a family and method.
std::string to_table(const KnobResult& result);

// For programs: a line of names, then one line a knob, family and method.
std::string to_csv(std::span<const KnobResult> results);

} // namespace raysteps
