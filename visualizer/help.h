#pragma once

#include "state.h"

#include <string>

namespace raysteps::view {

// What each key does, with the values as they are.
std::string help_text(const State& state);

} // namespace raysteps::view
