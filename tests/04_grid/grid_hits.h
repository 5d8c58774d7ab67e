#pragma once

#include "mirror/every_triangle.h"
#include "mirror/grid.h"
#include "structure/build_grid.h"
#include "structure/reach.h"
#include "support/gpu_hits.h"
#include "support/ray_families.h"
#include "support/same_bits.h"

#include <cstddef>
#include <span>
#include <vector>

namespace raysteps {

using EveryTriangle = mirror::EveryTriangleWatertight<float>;
using GridWalk = mirror::GridWatertight<float>;
using MailboxWalk = mirror::GridMailboxWatertight<float>;

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

inline Lattice lattice_of(const GridShape& shape) {
    return {shape.lower, shape.cell_size, shape.cells};
}

// The hits of a mirror whose walks are cut into so many rounds.
template <class Mirror>
std::vector<Hit> hits_by(Mirror mirror, std::span<const Ray> rays, int rounds = 1 << 30) {
    std::vector<Hit> hits;
    for (const Ray& ray : rays) {
        const auto own = mirror::to_mirror<Mirror>(ray);
        auto walk = mirror.start_walk(own);
        while (!walk.ended) {
            walk = mirror.go_on(walk, own, -mirror.farthest, rounds);
        }
        hits.push_back(mirror::from_mirror(walk.nearest));
    }
    return hits;
}

inline std::size_t count_different(std::span<const Hit> a, std::span<const Hit> b) {
    std::size_t different = a.size() == b.size() ? 0 : a.size() + b.size();
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
        different += same_bits(a[i], b[i]) ? 0 : 1;
    }
    return different;
}

inline std::size_t count_hits(std::span<const Hit> hits) {
    std::size_t count = 0;
    for (const Hit& hit : hits) {
        count += hit.triangle == no_triangle ? 0 : 1;
    }
    return count;
}

// How the walks through a grid compare with the loop over every triangle.
struct Agreement {
    std::size_t hits = 0; // of the loop
    std::size_t different = 0;
    std::size_t different_by_mailbox = 0;
};

inline Agreement agreement_of(const Scene& scene, const Grid& grid, std::span<const Ray> rays) {
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> expected = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    const std::vector<Hit> found = hits_by(mirror::mirror_of<GridWalk>(buffers, grid), rays);
    const std::vector<Hit> by_mailbox =
        hits_by(mirror::mirror_of<MailboxWalk>(buffers, grid), rays);
    return {count_hits(expected), count_different(found, expected),
            count_different(by_mailbox, expected)};
}

// The families of rays that know of the grid's planes.
inline std::vector<RayFamily> lattice_families(RandomNumbers& numbers, const GridShape& shape,
                                               int count) {
    const Lattice lattice = lattice_of(shape);
    const std::vector<Ray> through = rays_through_lattice_points(numbers, lattice, count);
    return {{"through lattice points", through},
            {"back through lattice points", reversed(through)},
            {"in lattice planes", rays_in_lattice_planes(numbers, lattice, count)}};
}

} // namespace raysteps
