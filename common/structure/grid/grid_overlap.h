#pragma once

#include "structure/grid/grid.h"

#include <array>

namespace raysteps {

// The cells first ... last of a line of cells; none where last < first.
struct CellRange {
    int first = 0;
    int last = -1;
};

// What a cell (x, y, z) must obey to overlap a triangle, along one direction:
// lowest <= factors.x * x + factors.y * y + factors.z * z <= highest.
struct OverlapRule {
    glm::dvec3 factors{0.0};
    double lowest = 0.0;
    double highest = 0.0;
};

// The cells of a grid that a triangle overlaps when they are grown by the padding: those that no
// direction separates from it. Of the 13 directions that can (Akenine-Moeller, "Fast 3D
// Triangle-Box Overlap Testing", 2001), each allows a range of cells along a line, so that only
// cells that belong are ever visited. Set up once a triangle, after Schwarz and Seidel, "Fast
// Parallel Surface and Solid Voxelization on GPUs", 2010. In double: the error, about 2^-50 of the
// grid's side, is far below what padding.h leaves.
struct TriangleOverlap {
    OverlapRule slice;                // of z alone
    OverlapRule box_rows;             // of y alone
    OverlapRule box_cells;            // of x alone
    std::array<OverlapRule, 3> rows;  // of y and z
    std::array<OverlapRule, 7> cells; // of x, y and z
    bool is_box = false; // the box around the triangle decides, and the last two are not set
};

// The triangle, padded, lies within the grid.
TriangleOverlap prepare_overlap(const GridShape& shape, const glm::vec3& a, const glm::vec3& b,
                                const glm::vec3& c);

// The slices z with a cell that belongs; in one of them the rows y; in one of those the cells x.
CellRange overlapped_slices(const GridShape& shape, const TriangleOverlap& overlap);
CellRange overlapped_rows(const GridShape& shape, const TriangleOverlap& overlap, int z);
CellRange overlapped_cells(const GridShape& shape, const TriangleOverlap& overlap, int y, int z);

// Calls visit(cell) with the number of each cell that belongs.
template <class Visit>
void visit_overlapped(const GridShape& shape, const TriangleOverlap& overlap, const Visit& visit) {
    const CellRange slices = overlapped_slices(shape, overlap);
    for (int z = slices.first; z <= slices.last; ++z) {
        const CellRange rows = overlapped_rows(shape, overlap, z);
        for (int y = rows.first; y <= rows.last; ++y) {
            const CellRange cells = overlapped_cells(shape, overlap, y, z);
            const std::int64_t row =
                std::int64_t{shape.cells.x} * (y + std::int64_t{shape.cells.y} * z);
            for (int x = cells.first; x <= cells.last; ++x) {
                visit(static_cast<std::size_t>(row + x));
            }
        }
    }
}

} // namespace raysteps
