#include "basics/timed.h"
#include "structure/grid/build_grid.h"
#include "structure/options.h"
#include "structure/tree_file/tree_file.h"

#include <algorithm>
#include <functional>
#include <string>

namespace raysteps {

namespace {

const std::vector<OptionRow<GridOptions>>& rows() {
    static const std::vector<OptionRow<GridOptions>> all{
        number_option("density", &GridOptions::density, 1e-6, 1e6, "cells per triangle"),
        number_option("resolution", &GridOptions::resolution, 0, 1 << 20,
                      "cells along the longest side, or 0 to follow --density"),
        number_option("memory-limit", &GridOptions::memory_limit, 1, 1 << 20,
                      "most memory for cells and references, in MiB", 1 << 20)};
    return all;
}

// How full the cells are: of empty ones a walk pays for nothing but the step.
struct Filling {
    std::int64_t leaves = 0; // cells that list anything
    std::int64_t longest = 0;
    std::int64_t repeats = 0; // references that a neighbour has as well
};

Filling filling_of(const Grid& grid) {
    Filling filling;
    for (std::size_t cell = 0; cell + 1 < grid.starts.size(); ++cell) {
        const std::int64_t length = grid.starts[cell + 1] - grid.starts[cell];
        filling.leaves += length > 0 ? 1 : 0;
        filling.longest = std::max(filling.longest, length);
    }
    filling.repeats = std::count_if(grid.references.begin(), grid.references.end(),
                                    [](std::int32_t r) { return r != triangle_of(r); });
    return filling;
}

BuiltStructure build(std::span<const glm::vec3> corners, const BuildRequest& request) {
    const GridOptions options = grid_options_of(request);
    const std::string file = asked_tree(request);
    auto [grid, seconds] = timed([&] {
        return file.empty() ? build_grid(corners, options)
                            : tree_from_file<Grid>(file, corners, std::identity{});
    });
    BuiltStructure built;
    built.facts = facts_of(grid, corners.size() / 3, seconds);
    built.packed = pack(std::move(grid));
    return built;
}

} // namespace

GridOptions grid_options_of(const BuildRequest& request) {
    GridOptions options = read_options(rows(), request);
    options.say = request.say;
    options.warn = request.warn;
    options.most_texels = request.most_texels;
    options.reach = static_cast<double>(request.reach);
    return options;
}

std::vector<Fact> facts_of(const Grid& grid, std::size_t triangles, double seconds) {
    const Filling filling = filling_of(grid);
    const auto references = static_cast<double>(grid.references.size());
    const auto leaves = static_cast<double>(filling.leaves);
    return {{"build_seconds", seconds},
            {"memory_bytes", static_cast<double>(memory_of(grid))},
            {"cells", static_cast<double>(cell_count(grid.shape))},
            {"cells_x", static_cast<double>(grid.shape.cells.x)},
            {"cells_y", static_cast<double>(grid.shape.cells.y)},
            {"cells_z", static_cast<double>(grid.shape.cells.z)},
            {"leaves", leaves},
            {"references", references},
            {"references_per_triangle",
             triangles == 0 ? 0.0 : references / static_cast<double>(triangles)},
            {"references_per_leaf", filling.leaves == 0 ? 0.0 : references / leaves},
            {"longest_leaf", static_cast<double>(filling.longest)},
            {"references_with_neighbours", static_cast<double>(filling.repeats)}};
}

// Serves structure/grid/grid.glsl and structure/grid/grid_mailbox.glsl.
StructureFamily family_grid() {
    std::vector<BuildOption> options = options_of(rows());
    options.push_back(tree_option);
    return {"grid", options, build};
}

} // namespace raysteps
