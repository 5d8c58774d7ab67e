#pragma once

#include "basics/ray.h"
#include "structure/grid/grid.h"

#include <cstdint>

namespace raysteps {

// Which cells a ray visits, as shaders/exhibit/trail_observer.glsl writes it down: how
// many, and a number for their order.
struct Trail {
    std::uint32_t visits = 0;
    std::uint32_t mixed = 2166136261U;
    bool is_close = false; // to an edge of a cell, so that floats cannot tell the order
};

// The trail of a ray that starts within the grid, by crossings that are computed in double from the
// planes of the grid, which are floats. Of equal crossings the first axis counts. A crossing in
// floats, (plane - origin) / direction, is rounded twice: by 2 e t, with e = 2^-24. So where two of
// them are within 4 e t of each other, and a fifth for the terms in e^2, either order is right, and
// a triangle that is listed by the padding of structure/padding.h is found in both.
Trail grid_trail(const GridShape& shape, const Ray& ray);

} // namespace raysteps
