#pragma once

#include "measure/ray_kinds.h"

#include <algorithm>

namespace raysteps {

// Neighbours in a run are as coherent as in the whole.
inline constexpr std::size_t rays_a_run = 64;

// Of each `step` runs of rays, the first: rays from all over the picture, for a contender that
// cannot trace them all in the time there is.
inline RayKind every_nth_run(const RayKind& kind, std::size_t step) {
    RayKind sample{kind.name, kind.query, {}};
    for (std::size_t begin = 0; begin < kind.rays.size(); begin += step * rays_a_run) {
        const std::size_t end = std::min(begin + rays_a_run, kind.rays.size());
        sample.rays.insert(sample.rays.end(),
                           kind.rays.begin() + static_cast<std::ptrdiff_t>(begin),
                           kind.rays.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return sample;
}

} // namespace raysteps
