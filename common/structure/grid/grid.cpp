#include "structure/grid/grid.h"

#include "structure/padding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace raysteps {

namespace {

// Below this a cell would be little more than the padding around it.
constexpr double least_paddings = 8.0;

// Planes are single-precision numbers: a thinner cell would have its planes on the same number.
constexpr double least_units_in_last_place = 8.0;

// Keeps all indices far below 2^24, where single precision has every whole number.
constexpr double most_cells_along_an_axis = 0x1p20;

double largest_coordinate(const Box& box) {
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        largest = std::max({largest, std::abs(static_cast<double>(box.lower[axis])),
                            std::abs(static_cast<double>(box.upper[axis]))});
    }
    return largest;
}

// The side of a cube of which `cells` fill the box. Along an axis where the box is thinner than
// that there is one cell, and the others share the cells among them.
double side_of_cell(const glm::dvec3& size, const glm::dvec3& most, double cells) {
    std::array<bool, 3> divided{most.x > 1.0, most.y > 1.0, most.z > 1.0};
    double side = 0.0;
    for (int round = 0; round < 3; ++round) { // each round but the last finds a thin axis
        double volume = 1.0;
        int dimensions = 0;
        for (int axis = 0; axis < 3; ++axis) {
            volume *= divided[static_cast<std::size_t>(axis)] ? size[axis] : 1.0;
            dimensions += divided[static_cast<std::size_t>(axis)] ? 1 : 0;
        }
        if (dimensions == 0) {
            break;
        }
        //# exercise 4.5: how large a cell is
        side = std::pow(volume / cells, 1.0 / dimensions);
        //# stub: side = volume;
        //# end
        for (int axis = 0; axis < 3; ++axis) {
            divided[static_cast<std::size_t>(axis)] &= size[axis] >= side;
        }
    }
    return side;
}

// The least size of a cell whose last plane is not inside the box.
float size_of_cell(float lower, float upper, int cells) {
    const double exact = (static_cast<double>(upper) - static_cast<double>(lower)) / cells;
    auto size = static_cast<float>(exact);
    while (grid_plane(lower, size, cells) < upper) { // a few roundings at most
        size = std::nextafter(size, std::numeric_limits<float>::infinity());
    }
    return size;
}

} // namespace

GridShape shape_grid(std::span<const glm::vec3> corners, const GridOptions& options) {
    GridShape shape;
    const Box bounds = bounds_of(corners);
    if (is_empty(bounds)) {
        return shape;
    }
    shape.padding = padding_for(usual_reach(bounds, options.reach));
    const Box box = pad(bounds, shape.padding);
    const glm::dvec3 size = glm::dvec3(box.upper) - glm::dvec3(box.lower);
    const double unit_in_last_place = 0x1p-23 * largest_coordinate(box);
    const double thinnest =
        std::max(least_paddings * shape.padding, least_units_in_last_place * unit_in_last_place);
    const glm::dvec3 most = glm::clamp(size / thinnest, 1.0, most_cells_along_an_axis);
    const std::size_t count = corners.size() / 3;
    const auto triangles = static_cast<double>(count);
    const double side = options.resolution > 0
                            ? std::max({size.x, size.y, size.z}) / options.resolution
                            : side_of_cell(size, most, options.density * triangles);
    shape.lower = box.lower;
    for (int axis = 0; axis < 3; ++axis) {
        const double wanted = side > 0.0 ? std::round(size[axis] / side) : 1.0;
        shape.cells[axis] = static_cast<int>(std::clamp(wanted, 1.0, std::floor(most[axis])));
        shape.cell_size[axis] = size_of_cell(box.lower[axis], box.upper[axis], shape.cells[axis]);
    }
    return shape;
}

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
