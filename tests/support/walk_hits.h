#pragma once

#include "compare_hits.h"
#include "mirror/mirror_scene.h"
#include "mirror/walks.h"

#include <span>
#include <vector>

namespace raysteps {

using EveryTriangle = mirror::walks::every_triangle<float>;

inline constexpr int whole_walk = 1 << 30; // rounds that no walk here needs

// The hits of a mirror whose walks are cut into so many rounds.
template <class Mirror>
std::vector<Hit> hits_by(Mirror mirror, std::span<const Ray> rays, int rounds = whole_walk) {
    std::vector<Hit> hits;
    hits.reserve(rays.size());
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

} // namespace raysteps
