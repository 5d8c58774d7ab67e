#pragma once

#include "program/command.h"

namespace raysteps {

// The paper's listing, each state of its repair beside the watertight test: a picture, and how many
// pixels it gets wrong, at the scene's own size and at a thousandth of it.
void show_exhibit(const Command& command, const Scene& scene);

} // namespace raysteps
