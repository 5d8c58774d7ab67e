#pragma once

#include "gpu/program.h"
#include "gpu/texture.h"

namespace raysteps {

// Runs the program once for each of `count` vertices, as points of one pixel wherever its vertex
// pass puts them, and adds what it draws to the texture. Points are added in their order, so the
// sums are the same each time.
void add_points(const Program& program, const Texture& texture, int count);

} // namespace raysteps
