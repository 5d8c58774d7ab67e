#pragma once

#include "program/command.h"
#include "render/rays.h"

#include <string>

namespace raysteps {

// interpolated or direct. Throws InputError.
RayGeneration parse_generation(const std::string& name);

// Measures both ways to make primary rays against the exact directions, prints the errors in ulp
// and the lengths of the directions, draws the errors as heat maps in one scale, and writes the
// numbers.
void compare_generations(const Command& command, const Camera& camera);

} // namespace raysteps
