#pragma once

#include "claims.h"

#include <string>
#include <vector>

namespace raysteps {

// How many lines of GLSL the walk needs: those of all files that its program includes and that of
// the loop over every triangle does not, without comments and empty lines. It knows nothing of the
// builders. Throws InputError where there is no such structure.
ProgramLength program_length(const std::string& structure);

} // namespace raysteps
