#include "hard_cases/lattice_rays.h"
#include "hard_cases/loose_triangles.h"
#include "mirror/grid.h"
#include "structure/build_grid.h"
#include "trials/checks.h"

#include <algorithm>

namespace raysteps {

namespace {

// A walk steps along each axis at most once a cell.
std::vector<TrialRow> length_of_walks(const TrialTools& tools) {
    RandomNumbers numbers(tools.seed);
    const Scene scene = add_mesh(Scene{}, random_triangles(numbers, 200), Material{});
    GridOptions options;
    options.resolution = 32;
    const Grid grid = build_grid(scene.corners, options);
    const mirror::SceneBuffers buffers(scene);
    auto counted = mirror::mirror_of<mirror::GridCounted<float>>(buffers, grid);
    const glm::ivec3 cells = grid.shape.cells;
    const auto limit = static_cast<unsigned>(cells.x + cells.y + cells.z - 2);
    std::size_t tried = 0;
    std::size_t wrong = 0;
    for (const RayFamily& family : lattice_families(numbers, lattice_of(grid.shape), 2000)) {
        for (const Ray& ray : family.rays) {
            counted.observe_from(mirror::uvec4(0U));
            counted.closest_hit(mirror::to_mirror<decltype(counted)>(ray));
            wrong += counted.observations().x <= limit ? 0 : 1;
            ++tried;
        }
    }
    return {promised_row("grid", "C++", std::to_string(limit) + " cells at most", wrong, tried)};
}

} // namespace

std::vector<Trial> grid_checks() {
    return {{"G10", "a walk visits no more cells than there are planes", "",
             "steps by whole numbers", length_of_walks}};
}

} // namespace raysteps
