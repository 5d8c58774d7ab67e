#pragma once

#include "structure/grid/grid.h"

#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <vector>

namespace raysteps {

// Asks a grid for everything that a walk takes for granted, by other means than its builder's. A
// sentence for each kind of fault, with the first place where it is; nothing where all is well.
std::vector<std::string> check_grid(const Grid& grid, std::span<const glm::vec3> corners);

} // namespace raysteps
