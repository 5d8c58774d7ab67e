#pragma once

#include "measure/ray_kinds.h"
#include "render/trace_rays.h"

#include <cstring>

namespace raysteps {

// A texture of the answers to that query.
inline Texture trace(TraceRays& tracer, const SceneTextures& scene, const RayTextures& rays,
                     Query query) {
    return query == Query::any ? tracer.any_hits(rays, scene) : tracer.closest_hits(rays, scene);
}

// Closest hits must agree in every bit; of any hit, only whether there is one is compared.
inline bool is_same_answer(const Hit& a, const Hit& b, Query query) {
    if (a.triangle < 0 || b.triangle < 0 || query == Query::any) {
        return (a.triangle < 0) == (b.triangle < 0);
    }
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// Of two lists of equal length.
inline std::size_t count_other_answers(std::span<const Hit> a, std::span<const Hit> b,
                                       Query query) {
    std::size_t others = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        others += is_same_answer(a[i], b[i], query) ? 0 : 1;
    }
    return others;
}

} // namespace raysteps
