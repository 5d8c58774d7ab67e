#pragma once

#include "structure/grid_shape.h"
#include "structure/packed_structure.h"

#include <cstdint>
#include <vector>

namespace raysteps {

// A uniform grid. The references [starts[cell], starts[cell + 1]) are those of the cell: all
// triangles that overlap it when it is grown by the padding, in ascending order.
struct Grid {
    GridShape shape;
    std::vector<std::int32_t> starts{0, 0};
    std::vector<std::int32_t> references;
};

// A reference has the triangle in its low 26 bits, and one bit a face of the cell, which says that
// the neighbour across that face lists the triangle as well. The face 2 * axis is the lower one of
// the axis, 2 * axis + 1 the upper one.
inline constexpr int triangle_bits = 26;
inline constexpr std::int32_t triangle_mask = (1 << triangle_bits) - 1;

inline std::int32_t triangle_of(std::int32_t reference) {
    return reference & triangle_mask;
}

inline bool is_in_neighbour(std::int32_t reference, int face) {
    return ((static_cast<std::uint32_t>(reference) >> (triangle_bits + face)) & 1U) != 0;
}

// As layout/grid.glsl has it.
PackedStructure pack(Grid grid);

} // namespace raysteps
