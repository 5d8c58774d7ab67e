#pragma once

#include "mirror/mirror_scene.h"
#include "mirror/walks.h"

#include <vector>

namespace raysteps {

// The hits that the mirror finds, with the triangle test that it is made of.
template <class Mirror>
std::vector<Hit> mirror_hits(const Scene& scene, std::span<const Ray> rays) {
    const mirror::SceneBuffers buffers(scene);
    Mirror mirror = mirror::mirror_of<Mirror>(buffers);
    std::vector<Hit> hits;
    hits.reserve(rays.size());
    for (const Ray& ray : rays) {
        hits.push_back(mirror::from_mirror(mirror.closest_hit(mirror::to_mirror<Mirror>(ray))));
    }
    return hits;
}

} // namespace raysteps
