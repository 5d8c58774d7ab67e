#pragma once

#include "mirror/bvh.h"
#include "mirror/every_triangle.h"
#include "scene/mesh.h"
#include "scene/scene.h"
#include "structure/build_bvh.h"
#include "structure/reach.h"
#include "support/ray_families.h"
#include "support/same_bits.h"

#include <algorithm>
#include <string>
#include <vector>

namespace raysteps {

using EveryTriangle = mirror::EveryTriangleWatertight<float>;

inline constexpr int whole_walk = 1 << 30; // rounds that no walk here needs

inline Scene grey_scene(const Mesh& mesh) {
    return add_mesh(Scene{}, mesh, Material{});
}

inline Bvh bvh_for(const Scene& scene, std::span<const Ray> rays, BvhOptions options = {}) {
    options.reach = static_cast<double>(reach_of(rays, scene.corners));
    return build_bvh(scene.corners, options);
}

// The hits of a mirror whose walks are cut into so many rounds.
template <class Mirror>
std::vector<Hit> hits_by(Mirror mirror, std::span<const Ray> rays, int rounds = whole_walk) {
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
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        different += same_bits(a[i], b[i]) ? 0 : 1;
    }
    return different;
}

inline std::size_t count_hits(std::span<const Hit> hits) {
    return static_cast<std::size_t>(std::count_if(
        hits.begin(), hits.end(), [](const Hit& hit) { return hit.triangle != no_triangle; }));
}

// Calls with the name and the mirror of each walk.
template <class Call>
void for_each_walk(const mirror::SceneBuffers& scene, const mirror::BvhBuffers& tree,
                   const Call& call) {
    call("bvh_skip", mirror::mirror_of<mirror::BvhSkip<float>>(scene, tree));
    call("bvh_skip_padded", mirror::mirror_of<mirror::BvhSkipPadded<float>>(scene, tree));
    call("bvh_ordered", mirror::mirror_of<mirror::BvhOrdered<float>>(scene, tree));
    call("bvh_parent", mirror::mirror_of<mirror::BvhParent<float>>(scene, tree));
    call("bvh_stack", mirror::mirror_of<mirror::BvhStack<float>>(scene, tree));
}

// How the walks' hits agree with those of the loop over every triangle.
struct Agreement {
    std::size_t hits = 0;   // of the loop
    std::string exceptions; // the walks that differ and how often; empty where none does
};

inline Agreement agreement_of(const Scene& scene, const Bvh& bvh, std::span<const Ray> rays,
                              int rounds = whole_walk) {
    const mirror::SceneBuffers buffers(scene);
    const mirror::BvhBuffers packed(bvh, scene.corners);
    const std::vector<Hit> expected = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    Agreement agreement{count_hits(expected), ""};
    for_each_walk(buffers, packed, [&](const std::string& name, const auto& mirror) {
        const std::size_t different = count_different(expected, hits_by(mirror, rays, rounds));
        if (different > 0) {
            agreement.exceptions += name + ": " + std::to_string(different) + " ";
        }
    });
    return agreement;
}

} // namespace raysteps
