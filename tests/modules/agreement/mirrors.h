#pragma once

#include "mirror/trace_by_mirror.h"
#include "structure/padding.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// The hits of every walk as C++, by the name of the structure.
inline std::map<std::string, std::vector<Hit>> hits_of_mirrors(const Scene& scene,
                                                               std::span<const Ray> rays) {
    const float reach = reach_of(rays, scene.corners);
    const mirror::SceneBuffers buffers(scene);
    std::map<std::string, std::vector<Hit>> hits;
    std::map<std::string, BuiltStructure> built;
    for (const auto& [name, trace] : mirror_walks()) {
        const StructureFamily family = family_of(name);
        const auto structure = built.find(family.name);
        if (structure == built.end()) {
            built.emplace(family.name, family.build(scene.corners, {reach, {}}));
        }
        hits["mirror of " + name] = trace(buffers, built.at(family.name).packed, rays);
    }
    return hits;
}

} // namespace raysteps
