#include "catch.h"
#include "grid_hits.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"
#include "structure/grid/build_grid.h"
#include "structure/grid/check_grid.h"
#include "structure/grid/grid.h"
#include "support/error_of.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace raysteps;

namespace {

const std::vector<std::string> no_faults;

// One small triangle in the middle of each cell of a lattice of unit cells.
std::vector<glm::vec3> one_a_unit_cell(int cells) {
    std::vector<glm::vec3> corners;
    for (int z = 0; z < cells; ++z) {
        for (int y = 0; y < cells; ++y) {
            for (int x = 0; x < cells; ++x) {
                const glm::vec3 middle = glm::vec3(x, y, z) + 0.5f;
                corners.insert(corners.end(),
                               {middle, middle + glm::vec3(0.1f, 0.0f, 0.0f), middle - 0.1f});
            }
        }
    }
    return corners;
}

std::vector<int> triangles_in(const Grid& grid, std::size_t cell) {
    std::vector<int> triangles;
    for (int i = grid.starts[cell]; i < grid.starts[cell + 1]; ++i) {
        triangles.push_back(triangle_of(grid.references[static_cast<std::size_t>(i)]));
    }
    return triangles;
}

} // namespace

TEST_CASE("a grid of small triangles lists each in its own cell", "[04][build]") {
    const std::vector<glm::vec3> corners = one_a_unit_cell(4);
    const Grid grid = build_grid(corners, with_resolution(4));
    CHECK(grid.shape.cells == glm::ivec3(4));
    REQUIRE(grid.references.size() == 64);
    for (int cell = 0; cell < 64; ++cell) {
        CHECK(triangles_in(grid, static_cast<std::size_t>(cell)) == std::vector<int>{cell});
        CHECK(grid.references[static_cast<std::size_t>(cell)] == cell); // in no neighbour
    }
    CHECK(check_grid(grid, corners) == no_faults);
}

TEST_CASE("a triangle across two cells knows its neighbour on either side", "[04][build]") {
    const std::vector<glm::vec3> corners{{0.0f, 0.0f, 0.0f}, {4.0f, 0.0f, 0.0f},
                                         {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 0.0f},
                                         {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
    const Grid grid = build_grid(corners, with_resolution(2));
    REQUIRE(grid.shape.cells == glm::ivec3(2, 1, 1));
    CHECK(triangles_in(grid, 0) == std::vector<int>{0, 1});
    CHECK(triangles_in(grid, 1) == std::vector<int>{0});
    for (int face = 0; face < 6; ++face) {
        CAPTURE(face);
        CHECK(is_in_neighbour(grid.references[0], face) == (face == 1));
        CHECK_FALSE(is_in_neighbour(grid.references[1], face));
        CHECK(is_in_neighbour(grid.references[2], face) == (face == 0));
    }
}

TEST_CASE("grids of no triangle and of one are valid", "[04][build]") {
    const Grid empty = build_grid({}, {});
    CHECK(empty.references.empty());
    CHECK(check_grid(empty, {}) == no_faults);
    const std::vector<glm::vec3> one{{0.0f, 0.0f, 0.0f}, {1.0f, 2.0f, 0.0f}, {3.0f, 0.0f, 1.0f}};
    const Grid grid = build_grid(one, {});
    CHECK_FALSE(grid.references.empty());
    CHECK(check_grid(grid, one) == no_faults);
    const std::vector<glm::vec3> point(3, glm::vec3(7.0f));
    const Grid of_a_point = build_grid(point, {});
    CHECK(of_a_point.shape.cells == glm::ivec3(1));
    CHECK(of_a_point.references == std::vector<std::int32_t>{0});
    CHECK(check_grid(of_a_point, point) == no_faults);
}

TEST_CASE("the density says how many cells a triangle there are", "[04][build]") {
    const int seed = 1;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    std::vector<glm::vec3> corners = random_triangles(numbers, 1000).corners;
    for (glm::vec3& corner : corners) {
        corner *= glm::vec3(8.0f, 2.0f, 1.0f);
    }
    for (const double density : {1.0, 4.0, 16.0}) {
        GridOptions options;
        options.density = density;
        const GridShape shape = build_grid(corners, options).shape;
        CAPTURE(density, shape.cells.x, shape.cells.y, shape.cells.z);
        // Each axis is rounded to whole cells: at most half of one in the fewest there are, 5.
        CHECK(static_cast<double>(cell_count(shape)) > 0.8 * density * 1000.0);
        CHECK(static_cast<double>(cell_count(shape)) < 1.25 * density * 1000.0);
        CHECK(shape.cell_size.x / shape.cell_size.z > 0.8f);
        CHECK(shape.cell_size.x / shape.cell_size.z < 1.25f);
    }
}

TEST_CASE("a flat scene has one cell across and its cells along", "[04][build][hard_case]") {
    std::vector<glm::vec3> corners = one_a_unit_cell(8);
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<glm::vec3> flat = corners;
        for (glm::vec3& corner : flat) {
            corner[axis] = 3.0f;
        }
        const Grid grid = build_grid(flat, {});
        CAPTURE(axis, grid.shape.cells.x, grid.shape.cells.y, grid.shape.cells.z);
        CHECK(grid.shape.cells[axis] == 1);
        // 4 * 512 = 2048 cells in a square, or 45.25 squared; x is a little longer than y and z.
        CHECK(std::abs(grid.shape.cells[(axis + 1) % 3] - 45) <= 1);
        CHECK(std::abs(grid.shape.cells[(axis + 2) % 3] - 45) <= 1);
        CHECK(check_grid(grid, flat) == no_faults);
    }
    for (glm::vec3& corner : corners) {
        corner = {corner.x, 1.0f, 2.0f};
    }
    CHECK(build_grid(corners, {}).shape.cells == glm::ivec3(2048, 1, 1));
}

TEST_CASE("a cell is never thinner than eight paddings", "[04][build]") {
    std::vector<glm::vec3> corners = one_a_unit_cell(4);
    for (glm::vec3& corner : corners) { // a thousand cells in a row, not in a cube
        corner = {corner.x, 0.0f, 0.0f};
    }
    for (const double reach : {1e2, 1e4, 1e5, 1e6, 1e9}) {
        GridOptions options = with_resolution(1000);
        options.reach = reach;
        const Grid grid = build_grid(corners, options);
        CAPTURE(reach, grid.shape.cells.x);
        CHECK((grid.shape.cells.x == 1 ||
               static_cast<double>(grid.shape.cell_size.x) >= 8.0 * grid.shape.padding));
        CHECK(check_grid(grid, corners) == no_faults);
    }
}

TEST_CASE("planes of a grid far from zero do not fall together", "[04][build]") {
    std::vector<glm::vec3> corners = one_a_unit_cell(16);
    for (glm::vec3& corner : corners) {
        corner += 1e6f; // where floats lie 1/16 apart
    }
    const Grid grid = build_grid(corners, with_resolution(1000));
    CHECK(grid.shape.cells.x > 4);
    for (int i = 0; i < grid.shape.cells.x; ++i) {
        CHECK(grid_plane(grid.shape.lower.x, grid.shape.cell_size.x, i) <
              grid_plane(grid.shape.lower.x, grid.shape.cell_size.x, i + 1));
    }
    CHECK(check_grid(grid, corners) == no_faults);
}

TEST_CASE("the number of threads changes nothing in a grid", "[04][build]") {
    const int seed = 2;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const std::vector<glm::vec3> corners = random_triangles(numbers, 3000).corners;
    GridOptions options;
    options.threads = 1;
    const Grid alone = build_grid(corners, options);
    for (const unsigned threads : {2U, 5U, 16U}) {
        options.threads = threads;
        const Grid together = build_grid(corners, options);
        CHECK(together.starts == alone.starts);
        CHECK(together.references == alone.references);
    }
}

TEST_CASE("what cannot be built is refused with what to do", "[04][build][errors]") {
    const std::vector<glm::vec3> corners = one_a_unit_cell(8);
    const auto error_with = [&](const GridOptions& options) {
        return error_of([&] { build_grid(corners, options); });
    };
    GridOptions options;
    options.density = 0.0;
    CHECK_THAT(error_with(options), contains_text("--density"));
    options.density = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT(error_with(options), contains_text("--density"));
    CHECK_THAT(error_with(with_resolution(-1)), contains_text("--resolution"));
    // 1,000,000,000 cells of four bytes each: 3,814 MiB.
    options = with_resolution(1000);
    options.memory_limit = 1LL << 30U;
    CHECK_THAT(error_with(options), contains_text("Take a smaller --resolution, or a larger "
                                                  "--memory-limit."));
    options = with_resolution(100000);
    options.memory_limit = 1LL << 60U;
    CHECK_THAT(error_with(options), contains_text("32-bit indices"));
    std::vector<glm::vec3> broken = corners;
    broken[7].y = std::numeric_limits<float>::quiet_NaN();
    CHECK_THAT(error_of([&] { build_grid(broken, {}); }), starts_with_text("Triangle 2 has"));
}

TEST_CASE("references over the memory limit are refused before they are taken",
          "[04][build][errors]") {
    // 2000 triangles as large as the grid, in 64 * 64 * 1 cells each.
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 2000; ++i) {
        corners.insert(corners.end(),
                       {{0.0f, 0.0f, 0.0f}, {64.0f, 0.0f, 0.0f}, {0.0f, 64.0f, 0.0f}});
    }
    GridOptions options = with_resolution(64);
    options.memory_limit = 8LL << 20U;
    const std::string error = error_of([&] { build_grid(corners, options); });
    CHECK_THAT(error, contains_text("a grid of 4096 cells"));
    CHECK_THAT(error, contains_text("--memory-limit"));
    options.memory_limit = 64LL << 20U;
    const Grid grid = build_grid(corners, options);
    CHECK(memory_of(grid) <= options.memory_limit);
    CHECK(grid.references.size() > std::size_t{2000} * 2048);
}

TEST_CASE("references that OpenGL does not read are refused before they are taken",
          "[04][build][errors]") {
    const std::vector<glm::vec3> corners = one_a_unit_cell(8);
    GridOptions options = with_resolution(16);
    const auto references =
        static_cast<std::int64_t>(build_grid(corners, options).references.size());
    const std::int64_t starts = 16 * 16 * 16 + 1;
    options.most_texels = std::max(references, starts);
    CHECK_NOTHROW(build_grid(corners, options));
    options.most_texels = starts - 1; // known before any triangle is looked at
    CHECK_THROWS_WITH(build_grid(corners, options),
                      starts_with_text("A grid of 4096 cells and 0 references or more") &&
                          contains_text("reads at most 4096 of each. Take a smaller --resolution"));
    CHECK_THROWS_AS(build_grid(corners, options), MachineError);

    std::vector<glm::vec3> large; // each in all of 4 x 4 x 1 cells' lower half
    for (int i = 0; i < 1000; ++i) {
        large.insert(large.end(), {{0.0f, 0.0f, 0.0f}, {4.0f, 0.0f, 0.0f}, {0.0f, 4.0f, 0.0f}});
    }
    BuildRequest request{.values = {{"resolution", "4"}}, .most_texels = 9999};
    std::string said;
    request.say = [&](const std::string& what) { said += what + "\n"; };
    CHECK_THROWS_AS(family_of("grid").build(large, request), MachineError);
    CHECK(said.find("references") == std::string::npos); // none was taken
    request.most_texels = 16000;
    CHECK_NOTHROW(family_of("grid").build(large, request));
}

TEST_CASE("a grid is slow where a ray along it meets more references than there are triangles",
          "[04][build]") {
    GridShape shape;
    shape.cells = {4, 4, 4266};
    const std::string slow = slow_grid(shape, 50618576, 20000); // over 16 columns: 3163661
    CHECK_THAT(slow, contains_text("20000 triangles are listed 50618576 times") &&
                         contains_text("a ray along z meets about 3163661 of them") &&
                         contains_text("Take --structure bvh_ordered"));
    CHECK(slow_grid(shape, 16 * 20000, 20000).empty());
    CHECK(!slow_grid(shape, 16 * 20001, 20000).empty());
    CHECK(slow_grid(shape, 16 * 999, 10).empty()); // no ray takes long there
    shape.cells = {4, 4266, 4};
    CHECK_THAT(slow_grid(shape, 50618576, 20000), contains_text("a ray along y"));
}

TEST_CASE("long triangles in a fine grid are warned of before they are listed", "[04][build]") {
    std::vector<glm::vec3> corners; // a bipyramid of 2 x 500 triangles, 1000 times as high as wide
    const auto around = [](int i) {
        const double angle = 2.0 * 3.14159265358979 * i / 500.0;
        return glm::vec3(std::cos(angle), std::sin(angle), 0.0);
    };
    for (int i = 0; i < 500; ++i) {
        for (const float apex : {1000.0f, -1000.0f}) {
            corners.insert(corners.end(), {around(i), around(i + 1), {0.0f, 0.0f, apex}});
        }
    }
    std::vector<std::string> sentences;
    BuildRequest request;
    request.warn = [&](const std::string& sentence) { sentences.push_back(sentence); };
    family_of("grid").build(corners, request);
    REQUIRE(sentences.size() == 1);
    CHECK_THAT(sentences[0], starts_with_text("This grid will be slow: 1000 triangles"));
    sentences.clear();
    family_of("bvh_ordered").build(corners, request);
    RandomNumbers numbers(3);
    family_of("grid").build(random_triangles(numbers, 5000).corners, request);
    family_of("grid").build(sphere({0, 0, 0}, 1.0f, 20).corners, request);
    CHECK(sentences.empty());
}

TEST_CASE("the check of a grid finds what is broken in it", "[04][build]") {
    const int seed = 3;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const std::vector<glm::vec3> corners = random_triangles(numbers, 200).corners;
    const Grid grid = build_grid(corners, {});
    REQUIRE(check_grid(grid, corners) == no_faults);
    const auto sentence_for = [&](const auto& spoil) {
        Grid spoiled = grid;
        spoil(spoiled);
        const std::vector<std::string> faults = check_grid(spoiled, corners);
        return faults.empty() ? "" : faults.front();
    };
    std::size_t full = 0; // a cell with two triangles or more
    while (grid.starts[full + 1] - grid.starts[full] < 2) {
        ++full;
    }
    const auto first = static_cast<std::size_t>(grid.starts[full]);
    CHECK_THAT(sentence_for([&](Grid& g) { g.starts.pop_back(); }), contains_text("starts for"));
    CHECK_THAT(sentence_for([&](Grid& g) { g.starts[full] += 100; }), contains_text("ends before"));
    CHECK_THAT(sentence_for([&](Grid& g) { g.starts.back() += 1; }), contains_text("do not run"));
    CHECK_THAT(sentence_for([&](Grid& g) { g.references[first] |= triangle_mask; }),
               contains_text("of 200"));
    CHECK_THAT(
        sentence_for([&](Grid& g) { std::swap(g.references[first], g.references[first + 1]); }),
        contains_text("out of order"));
    CHECK_THAT(sentence_for([&](Grid& g) { g.references[first] ^= 1 << (triangle_bits + 1); }),
               contains_text("across face 1"));
    CHECK_THAT(sentence_for([&](Grid& g) { g.shape.lower.x += 1.0f; }),
               contains_text("reaches out"));
    CHECK_THAT(sentence_for([&](Grid& g) { // the cell's first triangle is gone from it
                   g.references.erase(g.references.begin() + grid.starts[full]);
                   for (std::size_t cell = full + 1; cell < g.starts.size(); ++cell) {
                       --g.starts[cell];
                   }
               }),
               contains_text("across face") || contains_text("does not list it"));
}

TEST_CASE("ten million triangles make a grid within the memory limit", "[.measure]") {
    const int seed = 4;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    std::vector<glm::vec3> corners;
    for (int triangle = 0; triangle < 10'000'000; ++triangle) {
        const glm::vec3 center = numbers.in_cube();
        for (int corner = 0; corner < 3; ++corner) {
            corners.push_back(center + 0.005f * numbers.in_cube());
        }
    }
    const auto start = std::chrono::steady_clock::now();
    const Grid grid = build_grid(corners, {});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    WARN(cell_count(grid.shape) << " cells, " << grid.references.size() << " references, "
                                << memory_of(grid) / (1 << 20) << " MiB, " << seconds.count()
                                << " s");
    CHECK(memory_of(grid) <= GridOptions{}.memory_limit);
}
