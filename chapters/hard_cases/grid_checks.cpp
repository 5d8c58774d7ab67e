#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "mirror/walks.h"
#include "structure/grid/build_grid.h"
#include "trials.h"

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
    const PackedStructure packed = pack(grid);
    auto counted = mirror::mirror_of<mirror::walks::grid<float, mirror::Counter>>(buffers, packed);
    const glm::ivec3 cells = grid.shape.cells;
    const auto limit = static_cast<unsigned>(cells.x + cells.y + cells.z - 2);
    std::size_t tried = 0;
    std::size_t wrong = 0;
    for (const RayFamily& family : lattice_families(numbers, lattice_of(grid.shape), 2000)) {
        for (const Ray& ray : family.rays) {
            counted.observer = {};
            counted.closest_hit(mirror::to_mirror<decltype(counted)>(ray));
            wrong += counted.observer.visits <= limit ? 0 : 1;
            ++tried;
        }
    }
    return {promised_row("grid", "C++", std::to_string(limit) + " cells at most", wrong, tried)};
}

// Ends the walk when it leaves the first cell in which it has hit something, as the paper says.
template <class Mirror>
typename Mirror::Hit stop_at_first_cell(Mirror& mirror, const typename Mirror::Ray& ray) {
    auto walk = mirror.start_walk(ray);
    int cell = walk.place.x;
    while (!walk.ended && (walk.place.x == cell || !mirror.is_hit(walk.nearest))) {
        cell = walk.place.x;
        walk = mirror.go_on(walk, ray, -mirror.farthest, 1);
    }
    return walk.nearest;
}

std::vector<TrialRow> stop_rule(const TrialTools& tools) {
    RandomNumbers numbers(tools.seed);
    const Scene scene = add_mesh(Scene{}, random_triangles(numbers, 200), Material{});
    const mirror::SceneBuffers buffers(scene);
    auto loop = mirror::mirror_of<mirror::walks::every_triangle<float>>(buffers);
    const std::vector<Ray> rays =
        random_rays(numbers, tools.rays > 0 ? std::min(tools.rays, 100000) : 10000);
    std::vector<TrialRow> rows;
    for (const int resolution : {4, 8, 16, 32}) {
        GridOptions options;
        options.resolution = resolution;
        const Grid grid = build_grid(scene.corners, options);
        const PackedStructure packed = pack(grid);
        auto walker = mirror::mirror_of<mirror::walks::grid<float>>(buffers, packed);
        std::size_t wrong = 0;
        std::size_t wrong_at_first = 0;
        for (const Ray& given : rays) {
            const auto ray = mirror::to_mirror<decltype(walker)>(given);
            const int expected =
                loop.closest_hit(mirror::to_mirror<decltype(loop)>(given)).triangle;
            wrong += walker.closest_hit(ray).triangle == expected ? 0 : 1;
            wrong_at_first += stop_at_first_cell(walker, ray).triangle == expected ? 0 : 1;
        }
        const std::string cells = std::to_string(resolution) + " cells along an axis";
        rows.push_back(
            promised_row("only if t <= the cell's exit", "C++", cells, wrong, rays.size()));
        rows.push_back(reported_row("at the first cell with a hit", "C++", cells, wrong_at_first,
                                    rays.size()));
    }
    return rows;
}

} // namespace

std::vector<Trial> grid_checks() {
    return {{"P14", "stop as soon as a visited cell reports an intersection",
             "Wang and Wen, Research of Acceleration Structures for GPU Based Ray Tracing, 2010",
             "end the walk only if the hit lies before the cell's exit", stop_rule},
            {"G10", "a walk visits no more cells than there are planes", "",
             "steps by whole numbers", length_of_walks}};
}

} // namespace raysteps
