#include "grid_trail.h"

#include "structure/grid/grid.h"

#include <limits>

namespace raysteps {

namespace {

constexpr double too_close = 5.0 * 0x1p-24;

float plane_of(const GridShape& shape, int axis, int i) {
    return grid_plane(shape.lower[axis], shape.cell_size[axis], i);
}

// The cell that the ray starts in: a plane that it stands on is still before it.
int first_cell(const GridShape& shape, const Ray& ray, int axis) {
    int cell = 0;
    while (cell + 1 < shape.cells[axis] && plane_of(shape, axis, cell + 1) < ray.origin[axis]) {
        ++cell;
    }
    return cell;
}

double leaving(const GridShape& shape, const Ray& ray, int axis, int cell) {
    const double along = static_cast<double>(ray.direction[axis]);
    if (along == 0.0) {
        return std::numeric_limits<double>::infinity();
    }
    const int plane = along > 0.0 ? cell + 1 : cell;
    return (static_cast<double>(plane_of(shape, axis, plane)) -
            static_cast<double>(ray.origin[axis])) /
           along;
}

} // namespace

Trail grid_trail(const GridShape& shape, const Ray& ray) {
    glm::ivec3 cell(0);
    glm::dvec3 leaves(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        cell[axis] = first_cell(shape, ray, axis);
        leaves[axis] = leaving(shape, ray, axis, cell[axis]);
    }
    Trail trail;
    for (;;) {
        const int number = cell.x + shape.cells.x * (cell.y + shape.cells.y * cell.z);
        ++trail.visits;
        trail.mixed = (trail.mixed ^ static_cast<std::uint32_t>(number)) * 16777619U;
        int axis = leaves.x <= leaves.y ? 0 : 1;
        axis = leaves[axis] <= leaves.z ? axis : 2;
        for (int other = 0; other < 3; ++other) {
            const bool within = leaves[other] - leaves[axis] <= too_close * leaves[axis];
            trail.is_close = trail.is_close || (other != axis && within);
        }
        cell[axis] += ray.direction[axis] > 0.0f ? 1 : -1;
        if (cell[axis] < 0 || cell[axis] >= shape.cells[axis] || ray.direction[axis] == 0.0f) {
            return trail;
        }
        leaves[axis] = leaving(shape, ray, axis, cell[axis]);
    }
}

} // namespace raysteps
