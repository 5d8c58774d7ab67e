#pragma once

#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "mirror/walks.h"
#include "structure/grid/build_grid.h"
#include "structure/padding.h"
#include "support/gpu_hits.h"
#include "support/walk_hits.h"

#include <cstddef>
#include <span>
#include <vector>

namespace raysteps {

using GridWalk = mirror::walks::grid<float>;
using MailboxWalk = mirror::walks::grid_mailbox<float>;

inline Grid grid_for(const Scene& scene, std::span<const Ray> rays, GridOptions options = {}) {
    options.reach = static_cast<double>(reach_of(rays, scene.corners));
    return build_grid(scene.corners, options);
}

inline GridOptions with_resolution(int resolution) {
    GridOptions options;
    options.resolution = resolution;
    return options;
}

inline GridOptions with_density(double density) {
    GridOptions options;
    options.density = density;
    return options;
}

// How the walks through a grid compare with the loop over every triangle.
struct GridAgreement {
    std::size_t hits = 0; // of the loop
    std::size_t different = 0;
    std::size_t different_by_mailbox = 0;
};

inline GridAgreement agreement_of(const Scene& scene, const Grid& grid, std::span<const Ray> rays) {
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> expected = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    const PackedStructure packed = pack(grid);
    const std::vector<Hit> found = hits_by(mirror::mirror_of<GridWalk>(buffers, packed), rays);
    const std::vector<Hit> by_mailbox =
        hits_by(mirror::mirror_of<MailboxWalk>(buffers, packed), rays);
    return {count_hits(expected), count_different(found, expected),
            count_different(by_mailbox, expected)};
}

// Bit-equal with the loop; returns how many hits there are.
inline std::size_t check_agreement(const Scene& scene, const Grid& grid,
                                   std::span<const Ray> rays) {
    const GridAgreement agreement = agreement_of(scene, grid, rays);
    CHECK(agreement.different == 0);
    CHECK(agreement.different_by_mailbox == 0);
    return agreement.hits;
}

} // namespace raysteps
