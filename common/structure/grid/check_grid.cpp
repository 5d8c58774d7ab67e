#include "structure/grid/check_grid.h"

#include "structure/grid/build_grid.h"
#include "structure/grid/grid.h"

#include <algorithm>
#include <array>

namespace raysteps {

namespace {

using Faults = std::vector<std::string>;
using Planes = std::array<std::vector<float>, 3>;

std::string name_of(std::int64_t cell) {
    return "cell " + std::to_string(cell);
}

Faults faults_of_starts(const Grid& grid) {
    const std::int64_t cells = cell_count(grid.shape);
    if (grid.shape.cells.x < 1 || grid.shape.cells.y < 1 || grid.shape.cells.z < 1) {
        return {"there is not one cell along each axis."};
    }
    if (static_cast<std::int64_t>(grid.starts.size()) != cells + 1) {
        return {"there are " + std::to_string(grid.starts.size()) + " starts for " +
                std::to_string(cells) + " cells and one end."};
    }
    if (grid.starts.front() != 0 ||
        static_cast<std::size_t>(grid.starts.back()) != grid.references.size()) {
        return {"the starts do not run from the first reference to the end of the last."};
    }
    const auto descent = std::adjacent_find(grid.starts.begin(), grid.starts.end(),
                                            [](std::int32_t a, std::int32_t b) { return a > b; });
    if (descent != grid.starts.end()) {
        return {name_of(descent - grid.starts.begin()) + " ends before it starts."};
    }
    return {};
}

Planes planes_of(const GridShape& shape) {
    Planes planes;
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i <= shape.cells[axis]; ++i) {
            planes[static_cast<std::size_t>(axis)].push_back(
                grid_plane(shape.lower[axis], shape.cell_size[axis], i));
        }
    }
    return planes;
}

Faults faults_of_planes(const GridShape& shape, const Planes& planes,
                        std::span<const glm::vec3> corners) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!std::is_sorted(planes[axis].begin(), planes[axis].end())) {
            return {"the planes of axis " + std::to_string(axis) + " do not ascend."};
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto place = static_cast<double>(corners[i][static_cast<int>(axis)]);
            if (place - shape.padding < static_cast<double>(planes[axis].front()) ||
                place + shape.padding > static_cast<double>(planes[axis].back())) {
                return {"triangle " + std::to_string(i / 3) + " reaches out of the grid."};
            }
        }
    }
    return {};
}

std::span<const std::int32_t> references_of(const Grid& grid, std::int64_t cell) {
    const auto i = static_cast<std::size_t>(cell);
    const auto first = static_cast<std::size_t>(grid.starts[i]);
    return std::span(grid.references)
        .subspan(first, static_cast<std::size_t>(grid.starts[i + 1]) - first);
}

bool lists(const Grid& grid, std::int64_t cell, std::int32_t triangle) {
    const auto references = references_of(grid, cell);
    const auto place = std::lower_bound(references.begin(), references.end(), triangle,
                                        [](std::int32_t reference, std::int32_t wanted) {
                                            return triangle_of(reference) < wanted;
                                        });
    return place != references.end() && triangle_of(*place) == triangle;
}

Faults faults_of_references(const Grid& grid, std::size_t triangles) {
    for (std::int64_t cell = 0; cell < cell_count(grid.shape); ++cell) {
        std::int32_t before = -1;
        for (const std::int32_t reference : references_of(grid, cell)) {
            const std::int32_t triangle = triangle_of(reference);
            if (static_cast<std::size_t>(triangle) >= triangles) {
                return {name_of(cell) + " lists triangle " + std::to_string(triangle) + " of " +
                        std::to_string(triangles) + "."};
            }
            if (triangle <= before) {
                return {name_of(cell) + " lists triangle " + std::to_string(triangle) +
                        " out of order."};
            }
            before = triangle;
        }
    }
    return {};
}

Faults faults_of_neighbours(const Grid& grid) {
    for (std::int64_t cell = 0; cell < cell_count(grid.shape); ++cell) {
        for (const std::int32_t reference : references_of(grid, cell)) {
            for (int face = 0; face < 6; ++face) {
                const std::int64_t neighbour = neighbour_across(grid.shape, cell, face);
                const bool listed =
                    neighbour >= 0 && lists(grid, neighbour, triangle_of(reference));
                if (listed != is_in_neighbour(reference, face)) {
                    return {name_of(cell) + " is wrong about triangle " +
                            std::to_string(triangle_of(reference)) + " across face " +
                            std::to_string(face) + "."};
                }
            }
        }
    }
    return {};
}

// The cells along one axis that hold the place when they are grown by the padding.
std::array<std::int64_t, 2> cells_around(const std::vector<float>& planes, double place,
                                         double padding) {
    const auto below = std::lower_bound(planes.begin(), planes.end(), place - padding,
                                        [](float plane, double value) { return plane < value; });
    const auto above = std::upper_bound(planes.begin(), planes.end(), place + padding,
                                        [](double value, float plane) { return value < plane; });
    const auto last = static_cast<std::int64_t>(planes.size()) - 2;
    return {std::clamp<std::int64_t>(below - planes.begin() - 1, 0, last),
            std::clamp<std::int64_t>(above - planes.begin() - 1, 0, last)};
}

std::string missing_at(const Grid& grid, const Planes& planes, const glm::dvec3& point,
                       std::int32_t triangle) {
    std::array<std::array<std::int64_t, 2>, 3> range{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        range[axis] = cells_around(planes[axis], point[static_cast<int>(axis)], grid.shape.padding);
    }
    for (std::int64_t z = range[2][0]; z <= range[2][1]; ++z) {
        for (std::int64_t y = range[1][0]; y <= range[1][1]; ++y) {
            for (std::int64_t x = range[0][0]; x <= range[0][1]; ++x) {
                const std::int64_t cell = x + grid.shape.cells.x * (y + grid.shape.cells.y * z);
                if (!lists(grid, cell, triangle)) {
                    return name_of(cell) + " holds a point of triangle " +
                           std::to_string(triangle) + " and does not list it.";
                }
            }
        }
    }
    return "";
}

// Points all over each triangle: its corners, points of its edges, points within.
Faults faults_of_overlap(const Grid& grid, const Planes& planes,
                         std::span<const glm::vec3> corners) {
    constexpr int steps = 6;
    for (std::size_t triangle = 0; 3 * triangle < corners.size(); ++triangle) {
        const glm::dvec3 a(corners[3 * triangle]);
        const glm::dvec3 b(corners[3 * triangle + 1]);
        const glm::dvec3 c(corners[3 * triangle + 2]);
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; i + j <= steps; ++j) {
                const double u = static_cast<double>(i) / steps;
                const double v = static_cast<double>(j) / steps;
                const glm::dvec3 point = a + u * (b - a) + v * (c - a);
                const std::string fault =
                    missing_at(grid, planes, point, static_cast<std::int32_t>(triangle));
                if (!fault.empty()) {
                    return {fault};
                }
            }
        }
    }
    return {};
}

} // namespace

std::vector<std::string> check_grid(const Grid& grid, std::span<const glm::vec3> corners) {
    Faults faults = faults_of_starts(grid);
    if (faults.empty()) {
        faults = faults_of_references(grid, corners.size() / 3);
    }
    if (!faults.empty()) {
        return faults; // the other questions need lists that can be read
    }
    const Planes planes = planes_of(grid.shape);
    for (const Faults& more :
         {faults_of_planes(grid.shape, planes, corners), faults_of_neighbours(grid),
          faults_of_overlap(grid, planes, corners)}) {
        faults.insert(faults.end(), more.begin(), more.end());
    }
    return faults;
}

} // namespace raysteps
