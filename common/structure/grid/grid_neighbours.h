#pragma once

#include "structure/grid.h"

namespace raysteps {

// The number of the cell across a face (grid.h); -1 where the grid ends.
std::int64_t neighbour_across(const GridShape& shape, std::int64_t cell, int face);

// Sets the bits of all references that say which neighbours list the triangle as well. The
// references must be sorted, and hold triangles only. In time linear in their number.
Grid mark_neighbours(Grid grid, unsigned threads);

} // namespace raysteps
