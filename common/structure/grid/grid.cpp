#include "structure/grid.h"

#include <utility>

namespace raysteps {

PackedStructure pack(Grid grid) {
    PackedStructure packed;
    packed.points["grid_lower"] = grid.shape.lower;
    packed.points["grid_cell_size"] = grid.shape.cell_size;
    packed.counts["grid_cells"] = grid.shape.cells;
    packed.integers["grid_starts"] = std::move(grid.starts);
    packed.integers["grid_references"] = std::move(grid.references);
    return packed;
}

} // namespace raysteps
