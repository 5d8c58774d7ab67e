#include "catch.h"
#include "grid_hits.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"
#include "support/hard_scenes.h"

#include <algorithm>
#include <cmath>

using namespace raysteps;

TEST_CASE("G1 a hit beyond the cell does not end the walk", "[04][hard_case]") {
    // Triangle 0 is listed in the first cell and hit in the fourth; triangle 1 lies between.
    const Scene scene = scene_of(long_triangle_before_a_small_one());
    const std::vector<Ray> rays{{{0.0f, 0.5f, 0.5f}, {1.0f, 0.0f, 0.0f}, 0.0f, no_end}};
    const Grid grid = grid_for(scene, rays, with_resolution(4));
    REQUIRE(grid.shape.cells == glm::ivec3(4, 1, 1));
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(grid);
    CHECK(hits_by(mirror::mirror_of<GridWalk>(buffers, packed), rays).front().triangle == 1);
    CHECK(check_agreement(scene, grid, rays) == 1);
}

TEST_CASE("G2 a thousand cells along an axis agree with the loop", "[04][hard_case]") {
    const int seed = 2;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 1000);
    for (const int resolution : {128, 256}) {
        const Grid grid = grid_for(scene, rays, with_resolution(resolution));
        CHECK(check_agreement(scene, grid, rays) > 500);
    }
    const Scene flat = flattened(scene, 2, 0.25f); // a thousand cells are soon built there
    const std::vector<Ray> at_flat = rays_at_edges(numbers, flat.corners, 1000);
    const Grid grid = grid_for(flat, at_flat, with_resolution(1024));
    REQUIRE(std::max(grid.shape.cells.x, grid.shape.cells.y) == 1024);
    CHECK(check_agreement(flat, grid, at_flat) > 500);
}

TEST_CASE("G3 rays through lattice points hit a wall on the way there and back",
          "[04][hard_case]") {
    const int seed = 3;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    // The wall is far larger than the lattice of the loose triangles, so that each ray that goes
    // along x meets it, inside or on the edge that its two triangles share.
    const Scene scene = scene_of(wall_behind_loose_triangles(numbers));
    const Grid grid = grid_for(scene, {}, with_resolution(64));
    const GridShape middle{glm::vec3(-2.0f, -5.0f, -5.0f), grid.shape.cell_size,
                           glm::ivec3(grid.shape.cells.x, 8, 8), 0.0};
    std::vector<Ray> there = rays_through_lattice_points(numbers, lattice_of(middle), 3000);
    there.erase(std::remove_if(there.begin(), there.end(),
                               [](const Ray& ray) {
                                   return ray.origin.x * (ray.origin.x + 3 * ray.direction.x) >=
                                          0.0f;
                               }),
                there.end());
    REQUIRE(there.size() > 1000);
    const std::vector<Ray> back = reversed(there);
    CHECK(check_agreement(scene, grid, there) == there.size());
    CHECK(check_agreement(scene, grid, back) == back.size());
}

TEST_CASE("G4 triangles in the planes of cells and on the far face are hit", "[04][hard_case]") {
    const int seed = 4;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(triangles_in_planes_of_cells(numbers, 6));
    const std::vector<glm::vec3>& corners = scene.corners;
    const Grid grid = grid_for(scene, {}, with_resolution(6));
    REQUIRE(grid.shape.cells == glm::ivec3(6));
    // The triangles behind those of the box have corners where planes of this very grid meet.
    const float place = corners[36].x - grid.shape.lower.x;
    REQUIRE(std::abs(std::remainder(place, grid.shape.cell_size.x)) < 1e-5f);
    for (const RayFamily& family : ray_families(numbers, corners, 1500)) {
        CAPTURE(family.name);
        CHECK(check_agreement(scene, grid, family.rays) > 300);
    }
    for (const RayFamily& family : lattice_families(numbers, lattice_of(grid.shape), 1500)) {
        CAPTURE(family.name);
        CHECK(check_agreement(scene, grid, family.rays) > 300);
    }
}

TEST_CASE("G7 a flat scene is hit wherever the loop hits it", "[04][hard_case]") {
    const int seed = 7;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (int axis = 0; axis < 3; ++axis) {
        const Scene scene = flattened(scene_of(random_triangles(numbers, 200)), axis, 0.7f);
        for (const RayFamily& family : ray_families(numbers, scene.corners, 1000)) {
            CAPTURE(axis, family.name);
            check_agreement(scene, grid_for(scene, family.rays), family.rays);
        }
        const std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 1000);
        CHECK(check_agreement(scene, grid_for(scene, rays), rays) > 900);
    }
}

TEST_CASE("G9 a teapot in a stadium is right however slow", "[04][hard_case]") {
    const int seed = 9;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(teapot_in_a_stadium(numbers));
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 origin = 5.0f * numbers.in_cube();
        rays.push_back({origin, point_on_edge(numbers, scene.corners) - origin, 0.0f, no_end});
    }
    const Grid grid = grid_for(scene, rays);
    CHECK(check_agreement(scene, grid, rays) > 1500);
    // Nearly all of the 1000 triangles share a cell or two.
    std::int32_t longest = 0;
    for (std::size_t cell = 0; cell + 1 < grid.starts.size(); ++cell) {
        longest = std::max(longest, grid.starts[cell + 1] - grid.starts[cell]);
    }
    CHECK(longest > 900);
}
