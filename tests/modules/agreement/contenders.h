#pragma once

#include "gpu/shaders.h"
#include "render/trace_rays.h"
#include "scene/scene.h"
#include "structure/padding.h"
#include "structure/structure.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// All structures but the loop, and the packets, each with its program, compiled once. A context
// must be current.
class Contenders {
public:
    // The rounds of a launch are given as TraceRays takes them: the limits of the platform, or
    // their number. (The loop is always traced within the limits.)
    template <class Rounds>
    explicit Contenders(const Rounds& rounds) : loop_(tracer("every_triangle", measure_limits())) {
        for (const NamedPart& part : list_parts("structure")) {
            if (part.name != "every_triangle") {
                tracers_.emplace(part.name, tracer(part.name, rounds));
            }
        }
        for (const NamedPart& part : list_parts("packet")) {
            tracers_.emplace(part.name, tracer(part.name, rounds));
        }
    }

    std::vector<Hit> hits_of_loop(const Scene& scene, std::span<const Ray> rays) {
        return read_hits(loop_.closest_hits(upload_rays(rays), upload(scene)), rays.size());
    }

    // What all walks need of one scene, by the family: several walks share a structure.
    using Built = std::map<std::string, SceneTextures>;

    Built build(const Scene& scene, float reach) const {
        Built built;
        for (const auto& [name, tracer] : tracers_) {
            const StructureFamily family = family_of(name);
            if (!built.contains(family.name)) {
                built.emplace(family.name, upload(scene, family.build(scene.corners, {reach, {}})));
            }
        }
        return built;
    }

    // By the name of the structure.
    std::map<std::string, std::vector<Hit>> hits_of_all(const Built& built,
                                                        std::span<const Ray> rays) {
        RayTextures textures = upload_rays(rays);
        textures.coherence = Coherence::neighbours; // for packets
        std::map<std::string, std::vector<Hit>> hits;
        for (auto& [name, tracer] : tracers_) {
            const SceneTextures& scene = built.at(family_of(name).name);
            hits[name] = read_hits(tracer.closest_hits(textures, scene), rays.size());
        }
        return hits;
    }

    std::map<std::string, std::vector<Hit>> hits_of_all(const Scene& scene,
                                                        std::span<const Ray> rays) {
        return hits_of_all(build(scene, reach_of(rays, scene.corners)), rays);
    }

private:
    template <class Rounds>
    static TraceRays tracer(const std::string& structure, const Rounds& rounds) {
        return {walk_parts("watertight", structure), rounds, Packets::always};
    }

    TraceRays loop_;
    std::map<std::string, TraceRays> tracers_;
};

} // namespace raysteps
