#include "catch.h"
#include "grid_hits.h"

#include <algorithm>

using namespace raysteps;

namespace {

// The numbers of the cells that a walk visits, as it goes, one round at a time.
std::vector<int> cells_on_the_way(const Scene& scene, const Grid& grid, const Ray& ray) {
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(grid);
    GridWalk mirror = mirror::mirror_of<GridWalk>(buffers, packed);
    const auto own = mirror::to_mirror<GridWalk>(ray);
    std::vector<int> cells;
    auto walk = mirror.start_walk(own);
    while (!walk.ended) {
        if (cells.empty() || cells.back() != walk.place.x) {
            cells.push_back(walk.place.x);
        }
        walk = mirror.go_on(walk, own, -mirror.farthest, 1);
    }
    return cells;
}

// A wall across the grid at x = 8 - 1/8, and something small at either end of the grid.
Scene wall() {
    return scene_of_corners({{0.0f, 0.0f, 0.0f},
                             {0.0f, 0.125f, 0.0f},
                             {0.0f, 0.0f, 0.125f},
                             {8.0f, 8.0f, 8.0f},
                             {8.0f, 7.875f, 8.0f},
                             {8.0f, 8.0f, 7.875f},
                             {7.875f, 0.0f, 0.0f},
                             {7.875f, 16.0f, 0.0f},
                             {7.875f, 0.0f, 16.0f}});
}

} // namespace

TEST_CASE("a walk visits the cells that the ray crosses in their order", "[04][walk]") {
    const Scene scene = wall(); // x 0 ... 8, y and z 0 ... 16
    const Grid grid = grid_for(scene, {}, with_resolution(4));
    REQUIRE(grid.shape.cells == glm::ivec3(2, 4, 4));
    const auto cells = [&](const glm::vec3& origin, const glm::vec3& direction) {
        return cells_on_the_way(scene, grid, {origin, direction, 0.0f, 3.0f});
    };
    using Cells = std::vector<int>;
    CHECK(cells({1.0f, 1.0f, 1.0f}, {0.0f, 4.0f, 0.0f}) == Cells{0, 2, 4, 6});
    CHECK(cells({1.0f, 13.0f, 1.0f}, {0.0f, -4.0f, 0.0f}) == Cells{6, 4, 2, 0});
    CHECK(cells({1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 4.0f}) == Cells{0, 8, 16, 24});
    // y reaches each of its planes before z does.
    CHECK(cells({1.0f, 1.5f, 1.0f}, {0.0f, 4.0f, 4.0f}) == Cells{0, 2, 10, 12, 20, 22, 30});
    CHECK(cells({1.0f, 1.0f, 1.0f}, {0.0f, 0.1f, 0.1f}) == Cells{0}); // t_max is in the first
    CHECK(cells({1.0f, -1.0f, 1.0f}, {0.0f, -1.0f, 0.0f}).empty());
    CHECK(cells({1.0f, -9.0f, 1.0f}, {0.0f, 1.0f, 0.0f}).empty()); // t_max is before it
}

TEST_CASE("G5 origins inside and outside and on a face of the grid and pointing away",
          "[04][hard_case]") {
    const int seed = 5;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const Grid grid = grid_for(scene, {});
    const Lattice lattice = lattice_of(grid.shape);
    const glm::vec3 upper =
        lattice.lower + lattice.step * glm::vec3(lattice.cells); // a face, up to a rounding
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) {
        glm::vec3 origin = point_in_box(numbers, {lattice.lower, upper});
        const int axis = numbers.below(3);
        const bool at_upper = numbers.below(2) == 0;
        origin[axis] = at_upper ? upper[axis] : lattice.lower[axis]; // on a face
        if (i % 4 == 1) {
            origin[axis] += at_upper ? 1.0f : -1.0f; // outside
        } else if (i % 4 == 2) {
            origin = any_lattice_point(numbers, lattice);
        } else if (i % 4 == 3) {
            origin = point_in_box(numbers, {lattice.lower, upper});
        }
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    const std::size_t hits = check_agreement(scene, grid, rays);
    CHECK(hits > 500);
    CHECK(hits < 3500); // many point away
    const std::vector<Ray> away{{{0.0f, 0.0f, 9.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end},
                                {{0.0f, 0.0f, 9.0f}, {0.1f, 0.1f, 1.0f}, 0.0f, no_end}};
    CHECK(cells_on_the_way(scene, grid, away[0]).empty());
    CHECK(cells_on_the_way(scene, grid, away[1]).empty());
}

TEST_CASE("G6 a zero component keeps the ray in its cells and beside the grid misses",
          "[04][hard_case]") {
    const int seed = 6;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const Grid grid = grid_for(scene, {});
    CHECK(check_agreement(scene, grid, axis_parallel_rays(numbers, scene.corners, 4000)) > 400);
    CHECK(check_agreement(scene, grid, rays_with_a_zero(numbers, scene.corners, 4000)) > 2000);
    const glm::ivec3 cells = grid.shape.cells;
    const Ray along{{0.01f, 0.01f, -9.0f}, {0.0f, -0.0f, 1.0f}, 0.0f, no_end};
    const std::vector<int> visited = cells_on_the_way(scene, grid, along);
    REQUIRE(!visited.empty());
    for (std::size_t i = 1; i < visited.size(); ++i) {
        CHECK(visited[i] == visited[i - 1] + cells.x * cells.y);
    }
    const Ray beside{{0.01f, 9.0f, -9.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end};
    CHECK(cells_on_the_way(scene, grid, beside).empty());
}

TEST_CASE("G8 rays that are no rays are answered within the grid", "[04][hard_case]") {
    const int seed = 8;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 100));
    const Grid grid = grid_for(scene, {});
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(grid);
    GridWalk mirror = mirror::mirror_of<GridWalk>(buffers, packed);
    // A walk steps along each axis at most once a cell, and tests each reference at most once.
    const int most_rounds = grid.shape.cells.x + grid.shape.cells.y + grid.shape.cells.z +
                            static_cast<int>(grid.references.size());
    int walks = 0;
    for (const Ray& ray : nonsense_rays()) {
        const auto own = mirror::to_mirror<GridWalk>(ray);
        auto walk = mirror.start_walk(own);
        int rounds = 0;
        for (; !walk.ended && rounds <= most_rounds; ++rounds) {
            REQUIRE(walk.place.x >= 0);
            REQUIRE(walk.place.x < cell_count(grid.shape));
            walk = mirror.go_on(walk, own, -mirror.farthest, 1);
        }
        CHECK(rounds <= most_rounds);
        walks += rounds > 0 ? 1 : 0;
    }
    CHECK(walks > 20);
}

TEST_CASE("G10 a walk takes at most one step a cell along each axis", "[04][hard_case]") {
    const int seed = 10;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const Grid grid = grid_for(scene, {}, with_resolution(32));
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(grid);
    auto counted = mirror::mirror_of<mirror::walks::grid<float, mirror::Counter>>(buffers, packed);
    const glm::ivec3 cells = grid.shape.cells;
    unsigned most = 0;
    for (const RayFamily& family : lattice_families(numbers, lattice_of(grid.shape), 2000)) {
        for (const Ray& ray : family.rays) {
            counted.observer = {};
            counted.closest_hit(mirror::to_mirror<decltype(counted)>(ray));
            most = std::max(most, counted.observer.visits);
        }
    }
    CHECK(most > 32U);
    CHECK(most <= static_cast<unsigned>(cells.x + cells.y + cells.z - 2));
}
