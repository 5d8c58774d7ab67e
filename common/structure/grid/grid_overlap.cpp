#include "structure/grid/grid_overlap.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace raysteps {

namespace {

// The corners, from the grid's lower corner, and half the size of a cell with all that it is grown
// by.
struct PlacedTriangle {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 cell_size;
    glm::dvec3 half_cell;
};

PlacedTriangle place_triangle(const GridShape& shape, const glm::vec3& a, const glm::vec3& b,
                              const glm::vec3& c) {
    const glm::dvec3 lower(shape.lower);
    const glm::dvec3 size(shape.cell_size);
    const glm::dvec3 upper = lower + size * glm::dvec3(shape.cells);
    // A plane is rounded twice, by at most 2^-24 of the numbers at hand, which are at most the sum
    // of both ends: a cell reaches that much farther than its exact planes.
    const glm::dvec3 rounding = 0x1p-22 * (glm::abs(lower) + glm::abs(upper));
    return {{glm::dvec3(a) - lower, glm::dvec3(b) - lower, glm::dvec3(c) - lower},
            size,
            0.5 * size + shape.padding + rounding};
}

OverlapRule rule_along(const glm::dvec3& direction, const PlacedTriangle& triangle) {
    const double a = glm::dot(direction, triangle.corners[0]);
    const double b = glm::dot(direction, triangle.corners[1]);
    const double c = glm::dot(direction, triangle.corners[2]);
    const double radius = glm::dot(glm::abs(direction), triangle.half_cell);
    const glm::dvec3 factors = direction * triangle.cell_size;
    const double to_center = 0.5 * (factors.x + factors.y + factors.z);
    return {factors, std::min({a, b, c}) - radius - to_center,
            std::max({a, b, c}) + radius - to_center};
}

// The part of the range that obeys lowest <= factor * i <= highest.
CellRange narrow(CellRange range, double factor, double lowest, double highest) {
    if (range.last < range.first) {
        return {};
    }
    if (factor == 0.0) {
        return lowest <= 0.0 && highest >= 0.0 ? range : CellRange{};
    }
    const double from = (factor > 0.0 ? lowest : highest) / factor;
    const double to = (factor > 0.0 ? highest : lowest) / factor;
    // Clamped to one more on either side, so that a range outside comes out empty and no number is
    // too large for an int.
    const double below = range.first - 1.0;
    const double above = range.last + 1.0;
    return {std::max(range.first, static_cast<int>(std::clamp(std::ceil(from), below, above))),
            std::min(range.last, static_cast<int>(std::clamp(std::floor(to), below, above)))};
}

bool is_one_cell(const CellRange& range) {
    return range.first == range.last;
}

CellRange box_rows(const GridShape& shape, const TriangleOverlap& overlap) {
    const OverlapRule& rule = overlap.box_rows;
    return narrow({0, shape.cells.y - 1}, rule.factors.y, rule.lowest, rule.highest);
}

CellRange box_cells(const GridShape& shape, const TriangleOverlap& overlap) {
    const OverlapRule& rule = overlap.box_cells;
    return narrow({0, shape.cells.x - 1}, rule.factors.x, rule.lowest, rule.highest);
}

} // namespace

TriangleOverlap prepare_overlap(const GridShape& shape, const glm::vec3& a, const glm::vec3& b,
                                const glm::vec3& c) {
    const PlacedTriangle triangle = place_triangle(shape, a, b, c);
    TriangleOverlap overlap;
    overlap.slice = rule_along({0.0, 0.0, 1.0}, triangle);
    overlap.box_rows = rule_along({0.0, 1.0, 0.0}, triangle);
    overlap.box_cells = rule_along({1.0, 0.0, 0.0}, triangle);
    // A triangle whose box overlaps one line of cells only lies within it, and meets each of them.
    const int single = (is_one_cell(overlapped_slices(shape, overlap)) ? 1 : 0) +
                       (is_one_cell(box_rows(shape, overlap)) ? 1 : 0) +
                       (is_one_cell(box_cells(shape, overlap)) ? 1 : 0);
    overlap.is_box = single >= 2;
    if (overlap.is_box) {
        return overlap;
    }
    const std::array<glm::dvec3, 3> edges{triangle.corners[1] - triangle.corners[0],
                                          triangle.corners[2] - triangle.corners[1],
                                          triangle.corners[0] - triangle.corners[2]};
    for (std::size_t i = 0; i < 3; ++i) { // the products of an edge with the axes
        const glm::dvec3& edge = edges[i];
        overlap.rows[i] = rule_along({0.0, -edge.z, edge.y}, triangle);
        overlap.cells[2 * i] = rule_along({edge.z, 0.0, -edge.x}, triangle);
        overlap.cells[2 * i + 1] = rule_along({-edge.y, edge.x, 0.0}, triangle);
    }
    overlap.cells[6] = rule_along(glm::cross(edges[0], edges[1]), triangle);
    return overlap;
}

CellRange overlapped_slices(const GridShape& shape, const TriangleOverlap& overlap) {
    const OverlapRule& rule = overlap.slice;
    return narrow({0, shape.cells.z - 1}, rule.factors.z, rule.lowest, rule.highest);
}

CellRange overlapped_rows(const GridShape& shape, const TriangleOverlap& overlap, int z) {
    CellRange range = box_rows(shape, overlap);
    if (overlap.is_box) {
        return range;
    }
    for (const OverlapRule& rule : overlap.rows) {
        const double start = rule.factors.z * z;
        range = narrow(range, rule.factors.y, rule.lowest - start, rule.highest - start);
    }
    return range;
}

CellRange overlapped_cells(const GridShape& shape, const TriangleOverlap& overlap, int y, int z) {
    CellRange range = box_cells(shape, overlap);
    if (overlap.is_box) {
        return range;
    }
    for (const OverlapRule& rule : overlap.cells) {
        const double start = rule.factors.y * y + rule.factors.z * z;
        range = narrow(range, rule.factors.x, rule.lowest - start, rule.highest - start);
    }
    return range;
}

} // namespace raysteps
