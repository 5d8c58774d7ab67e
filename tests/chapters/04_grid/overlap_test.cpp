#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "structure/grid/grid.h"
#include "structure/grid/grid_overlap.h"
#include "structure/kd_tree/kd_split.h"

#include <set>

using namespace raysteps;

namespace {

using Corners = std::array<glm::vec3, 3>;

// A grid of unit cells from zero on, with this padding.
GridShape unit_cells(const glm::ivec3& cells, double padding) {
    GridShape shape;
    shape.cells = cells;
    shape.padding = padding;
    return shape;
}

std::set<std::size_t> overlapped(const GridShape& shape, const Corners& corners) {
    std::set<std::size_t> cells;
    const TriangleOverlap overlap = prepare_overlap(shape, corners[0], corners[1], corners[2]);
    visit_overlapped(shape, overlap, [&](std::size_t cell) {
        REQUIRE(cells.insert(cell).second); // once each
    });
    return cells;
}

// The same by clipping the triangle to each cell, grown by the padding.
std::set<std::size_t> clipped(const GridShape& shape, const Corners& corners, double padding) {
    std::set<std::size_t> cells;
    for (int z = 0; z < shape.cells.z; ++z) {
        for (int y = 0; y < shape.cells.y; ++y) {
            for (int x = 0; x < shape.cells.x; ++x) {
                const glm::ivec3 cell(x, y, z);
                Box box;
                for (int axis = 0; axis < 3; ++axis) {
                    const float lower = shape.lower[axis];
                    const float size = shape.cell_size[axis];
                    box.lower[axis] = grid_plane(lower, size, cell[axis]);
                    box.upper[axis] = grid_plane(lower, size, cell[axis] + 1);
                }
                if (!is_empty(clipped_bounds(corners, grown(box, padding), 0.0))) {
                    cells.insert(
                        static_cast<std::size_t>(x + shape.cells.x * (y + shape.cells.y * z)));
                }
            }
        }
    }
    return cells;
}

bool contains_all(const std::set<std::size_t>& all, const std::set<std::size_t>& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

} // namespace

TEST_CASE("a triangle along the diagonal overlaps the cells of the diagonal", "[04][overlap]") {
    // Its box covers all 64 cells of the layer.
    const Corners thin{glm::vec3(0.25f, 0.25f, 0.5f), {7.75f, 7.75f, 0.5f}, {7.75f, 7.75f, 0.6f}};
    std::set<std::size_t> diagonal;
    for (std::size_t i = 0; i < 8; ++i) {
        diagonal.insert(9 * i);
    }
    const std::set<std::size_t> cells = overlapped(unit_cells({8, 8, 1}, 1e-6), thin);
    CHECK(contains_all(cells, diagonal));
    // It runs through the cells' corners, so it touches the two cells beside each of them.
    CHECK(cells.size() == 8 + 2 * 7);
}

TEST_CASE("the cells before and behind a slanted triangle are not overlapped", "[04][overlap]") {
    // The plane x + y + z = 4.5 cuts the cells with x + y + z in 2 ... 4, of which the triangle
    // covers all: 6 + 10 + 12 of 64.
    const Corners slanted{glm::vec3(4.5f, 0.0f, 0.0f), {0.0f, 4.5f, 0.0f}, {0.0f, 0.0f, 4.5f}};
    CHECK(overlapped(unit_cells({4, 4, 4}, 1e-6), slanted).size() == 6 + 10 + 12);
}

TEST_CASE("a triangle that touches a cell overlaps it", "[04][overlap]") {
    const GridShape shape = unit_cells({3, 3, 3}, 1e-6);
    const Corners on_plane{glm::vec3(1.2f, 1.2f, 1.0f), {1.8f, 1.2f, 1.0f}, {1.2f, 1.8f, 1.0f}};
    CHECK(overlapped(shape, on_plane) == std::set<std::size_t>{4, 13});
    const Corners point{glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(1.0f)};
    CHECK(overlapped(shape, point) == std::set<std::size_t>{0, 1, 3, 4, 9, 10, 12, 13});
}

TEST_CASE("a triangle outside the grid overlaps nothing", "[04][overlap]") {
    const GridShape shape = unit_cells({3, 3, 3}, 1e-6);
    for (int axis = 0; axis < 3; ++axis) {
        for (const float place : {-1.0f, 4.0f}) {
            Corners corners{glm::vec3(1.2f), {1.8f, 1.2f, 1.7f}, {1.2f, 1.8f, 1.1f}};
            for (glm::vec3& corner : corners) {
                corner[axis] = place;
            }
            CHECK(overlapped(shape, corners).empty());
        }
    }
}

TEST_CASE("the cells of a triangle are those that it leaves something in when it is clipped",
          "[04][overlap]") {
    const int seed = 1;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    std::size_t total = 0;
    for (int i = 0; i < 600; ++i) {
        GridShape shape;
        shape.lower = numbers.in_cube() - 2.0f;
        shape.cell_size = 0.3f * numbers.in_cube() + 0.5f;
        shape.cells = {8, 7, 6};
        shape.padding = 1e-3;
        const glm::vec3 size = shape.cell_size * glm::vec3(shape.cells);
        const glm::vec3 middle = shape.lower + 0.5f * size + 0.2f * size * numbers.in_cube();
        const float length = i % 3 == 0 ? 0.25f : 0.05f; // of the grid's
        const float width = i % 2 == 0 ? length : 1e-5f;
        const Corners corners{middle, middle + length * size * numbers.in_cube(),
                              middle + width * size * numbers.in_cube()};
        const std::set<std::size_t> cells = overlapped(shape, corners);
        CAPTURE(i);
        CHECK(contains_all(cells, clipped(shape, corners, shape.padding)));
        // No more than cells that are grown a little more: coordinates are under 8 here, so the
        // builder adds at most 2^-22 * 2 * 8 < 4e-6 for the rounding of planes.
        CHECK(contains_all(clipped(shape, corners, shape.padding + 5e-6), cells));
        total += cells.size();
    }
    CHECK(total > 1500);
}
