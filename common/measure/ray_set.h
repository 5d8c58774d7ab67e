#pragma once

#include "compare/sample_rays.h"
#include "measure/answers.h"
#include "render/ray_textures.h"

#include <map>

namespace raysteps {

// Rays of one kind, or a part of them, with the answers that all have to give.
struct RaySet {
    RayKind kind;
    RayTextures textures;
    std::vector<Hit> expected;
};

// The rays of one kind, and their samples, each made when it is asked for first.
class RaySets {
public:
    RaySets(RayKind kind, TraceRays& judge, const SceneTextures& scene)
        : kind_(std::move(kind)), judge_(judge), scene_(scene) {}

    const RayKind& whole() const { return kind_; }

    // Of each `step` runs of rays, one.
    const RaySet& sample(std::size_t step) {
        const auto known = sets_.find(step);
        if (known != sets_.end()) {
            return known->second;
        }
        RayKind kind = every_nth_run(kind_, step);
        RayTextures textures = upload_rays(kind.rays);
        std::vector<Hit> expected =
            read_hits(trace(judge_, scene_, textures, kind.query), kind.rays.size());
        return sets_
            .emplace(step, RaySet{std::move(kind), std::move(textures), std::move(expected)})
            .first->second;
    }

private:
    RayKind kind_;
    TraceRays& judge_;
    const SceneTextures& scene_;
    std::map<std::size_t, RaySet> sets_;
};

} // namespace raysteps
