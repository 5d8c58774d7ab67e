#include "catch.h"
#include "grid_hits.h"
#include "structure/grid/grid.h"

#include <algorithm>
#include <iostream>

using namespace raysteps;

// What goes wrong when a grid is walked as it is often told, so that the lesson can show it and the
// tests of the right walk are known to see it.

namespace {

// The paper's rule: stop as soon as a visited cell reports a hit.
std::vector<Hit> hits_stopping_at_first(const mirror::SceneBuffers& buffers, const Grid& grid,
                                        std::span<const Ray> rays) {
    const PackedStructure packed = pack(grid);
    GridWalk mirror = mirror::mirror_of<GridWalk>(buffers, packed);
    std::vector<Hit> hits;
    for (const Ray& ray : rays) {
        const auto own = mirror::to_mirror<GridWalk>(ray);
        auto walk = mirror.start_walk(own);
        int cell = walk.place.x;
        while (!walk.ended) {
            walk = mirror.go_on(walk, own, -mirror.farthest, 1);
            const bool left = walk.place.x != cell;
            cell = walk.place.x;
            walk.ended = walk.ended || (left && mirror.is_hit(walk.nearest));
        }
        hits.push_back(mirror::from_mirror(walk.nearest));
    }
    return hits;
}

// The usual arithmetic: where a cell is left is added up, step by step. The cells that it visits.
std::vector<glm::ivec3> cells_by_adding_up(const Grid& grid, const Ray& ray) {
    const GridShape& shape = grid.shape;
    glm::ivec3 cell{};
    glm::vec3 leaves{};
    glm::vec3 each{};
    for (int axis = 0; axis < 3; ++axis) {
        cell[axis] =
            static_cast<int>((ray.origin[axis] - shape.lower[axis]) / shape.cell_size[axis]);
        const int plane = ray.direction[axis] > 0.0f ? cell[axis] + 1 : cell[axis];
        leaves[axis] =
            (grid_plane(shape.lower[axis], shape.cell_size[axis], plane) - ray.origin[axis]) /
            ray.direction[axis];
        each[axis] = std::abs(shape.cell_size[axis] / ray.direction[axis]);
    }
    std::vector<glm::ivec3> cells{cell};
    for (;;) {
        const int axis = leaves.x <= leaves.y && leaves.x <= leaves.z ? 0
                         : leaves.y <= leaves.z                       ? 1
                                                                      : 2;
        cell[axis] += ray.direction[axis] > 0.0f ? 1 : -1;
        leaves[axis] += each[axis];
        if (cell[axis] < 0 || cell[axis] >= shape.cells[axis]) {
            return cells;
        }
        cells.push_back(cell);
    }
}

std::vector<glm::ivec3> cells_by_index(const Grid& grid, const Ray& ray) {
    GridWalk mirror{};
    mirror.grid_lower = grid.shape.lower;
    mirror.grid_cell_size = grid.shape.cell_size;
    mirror.grid_cells = grid.shape.cells;
    const std::vector<std::int32_t> no_references(
        static_cast<std::size_t>(cell_count(grid.shape)) + 1, 0);
    mirror.grid_starts.texels = no_references;
    const auto own = mirror::to_mirror<GridWalk>(ray);
    std::vector<glm::ivec3> cells;
    for (auto walk = mirror.start_walk(own); !walk.ended;
         walk = mirror.go_on(walk, own, -mirror.farthest, 1)) {
        cells.push_back(mirror.grid_cell_of(walk.place.x));
    }
    return cells;
}

} // namespace

TEST_CASE("a walk that stops at the first hit in a cell is wrong in any grid", "[04][exhibit]") {
    const int seed = 1;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 500));
    const std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 5000);
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> expected = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    for (const int resolution : {4, 8, 16, 32}) {
        const Grid grid = grid_for(scene, rays, with_resolution(resolution));
        const std::size_t wrong =
            count_different(hits_stopping_at_first(buffers, grid, rays), expected);
        std::cout << "04: stopping at the first hit, " << resolution << " cells an axis: " << wrong
                  << " of " << rays.size() << " rays are wrong\n";
        CHECK(wrong > 50);
        const PackedStructure packed = pack(grid);
        CHECK(count_different(hits_by(mirror::mirror_of<GridWalk>(buffers, packed), rays),
                              expected) == 0);
    }
}

TEST_CASE("crossings that are added up drift into other cells", "[04][exhibit]") {
    const int seed = 2;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    std::size_t before = 0;
    for (const int resolution : {16, 128, 1024}) {
        Grid grid; // no triangles: only the cells count
        grid.shape.cells = glm::ivec3(resolution, resolution, 1);
        grid.shape.cell_size = glm::vec3(1.0f / static_cast<float>(resolution));
        grid.shape.cell_size.z = 1.0f;
        std::size_t different = 0;
        const int rays = 1000;
        for (int i = 0; i < rays; ++i) {
            const glm::vec3 start(0.01f * numbers.unit(), 0.01f * numbers.unit(), 0.1f);
            const glm::vec3 direction(0.5f + 0.5f * numbers.unit(), 0.5f + 0.5f * numbers.unit(),
                                      0.01f);
            const Ray ray{start, direction, 0.0f, no_end};
            different += cells_by_adding_up(grid, ray) != cells_by_index(grid, ray) ? 1 : 0;
        }
        std::cout << "04: adding up, " << resolution << " cells an axis: " << different << " of "
                  << rays << " rays visit other cells\n";
        CHECK(different >= before);
        before = different;
    }
    CHECK(before > 100);
}
