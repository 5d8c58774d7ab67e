#pragma once

#include "compare_hits.h"

#include <algorithm>

namespace raysteps {

// How many answers to rays that may be no rays (hard_cases/aimed_rays.h) cannot be right: a
// triangle that the scene does not have, or a hit of a ray that is empty.
inline std::size_t count_impossible(std::span<const Hit> hits, std::span<const Ray> rays,
                                    int triangles) {
    std::size_t impossible = hits.size() == rays.size() ? 0 : hits.size() + rays.size();
    for (std::size_t i = 0; i < std::min(hits.size(), rays.size()); ++i) {
        const bool empty = rays[i].t_max < rays[i].t_min || rays[i].direction == glm::vec3(0.0f);
        const int end = empty ? 0 : triangles;
        const bool is_possible =
            hits[i].triangle == no_triangle || (hits[i].triangle >= 0 && hits[i].triangle < end);
        impossible += is_possible ? 0 : 1;
    }
    return impossible;
}

} // namespace raysteps
