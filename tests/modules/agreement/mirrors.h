#pragma once

#include "mirror/grid.h"
#include "mirror/kd_tree.h"
#include "structure/grid/build_grid.h"
#include "structure/kd_tree/build_kd_tree.h"
#include "structure/padding.h"
#include "support/walk_hits.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// The hits of the walks as C++, by the name of the structure.
inline std::map<std::string, std::vector<Hit>> hits_of_mirrors(const Scene& scene,
                                                               std::span<const Ray> rays) {
    using namespace mirror;
    const auto reach = static_cast<double>(reach_of(rays, scene.corners));
    const SceneBuffers buffers(scene);
    GridOptions grid_options;
    grid_options.reach = reach;
    const Grid grid = build_grid(scene.corners, grid_options);
    KdOptions kd_options;
    kd_options.reach = reach;
    const KdBuffers tree(build_kd_tree(scene.corners, kd_options));
    return {
        {"mirror of grid", hits_by(mirror_of<GridWatertight<float>>(buffers, grid), rays)},
        {"mirror of grid_mailbox",
         hits_by(mirror_of<GridMailboxWatertight<float>>(buffers, grid), rays)},
        {"mirror of kd_restart", hits_by(mirror_of<KdRestart<float>>(buffers, tree), rays)},
        {"mirror of kd_backtrack", hits_by(mirror_of<KdBacktrack<float>>(buffers, tree), rays)},
        {"mirror of kd_short_stack", hits_by(mirror_of<KdShortStack<float>>(buffers, tree), rays)},
        {"mirror of kd_ropes", hits_by(mirror_of<KdRopesWalk<float>>(buffers, tree), rays)}};
}

} // namespace raysteps
