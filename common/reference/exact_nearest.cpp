#include "reference/exact_nearest.h"

#include "parallel/on_threads.h"
#include "reference/exact_solution.h"
#include "reference/sure_miss.h"

#include <array>
#include <cmath>

namespace raysteps {

namespace {

using Corners = std::array<glm::vec3, 3>;

bool is_finite(const glm::vec3& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

// Asks, without rounding, each triangle that `is_candidate` lets pass.
template <class Filter>
ReferenceHit nearest_of(const Ray& ray, std::span<const glm::vec3> corners,
                        const Filter& is_candidate) {
    ReferenceHit nearest{.t = ray.t_max};
    if (!is_usable(ray)) {
        return nearest;
    }
    ExactSolution nearest_solution;
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
        const Corners triangle{corners[first], corners[first + 1], corners[first + 2]};
        if (!is_finite(triangle[0]) || !is_finite(triangle[1]) || !is_finite(triangle[2]) ||
            !is_candidate(ray, triangle)) {
            continue;
        }
        const ExactSolution solution = solve_exactly(ray, triangle);
        if (!is_hit(solution, ray)) {
            continue;
        }
        // Of equal t the first, and so the smallest, index stays.
        if (!nearest_solution.unique || is_less(solution.t, nearest_solution.t)) {
            nearest_solution = solution;
            nearest.triangle = static_cast<int>(first / 3);
        }
    }
    if (nearest.triangle == no_triangle) {
        return nearest;
    }
    return {nearest_double(nearest_solution.t), nearest_double(nearest_solution.u),
            nearest_double(nearest_solution.v), nearest.triangle};
}

} // namespace

ReferenceHit exact_nearest_hit(const Ray& ray, std::span<const glm::vec3> corners) {
    return nearest_of(ray, corners, [](const Ray& line, const Corners& triangle) {
        return !surely_misses(line, triangle);
    });
}

ReferenceHit exact_nearest_hit_unfiltered(const Ray& ray, std::span<const glm::vec3> corners) {
    return nearest_of(ray, corners, [](const Ray&, const Corners&) { return true; });
}

std::vector<ReferenceHit> exact_nearest_hits(std::span<const Ray> rays,
                                             std::span<const glm::vec3> corners) {
    std::vector<ReferenceHit> hits(rays.size());
    on_threads(all_cores, rays.size(),
               [&](std::size_t i) { hits[i] = exact_nearest_hit(rays[i], corners); });
    return hits;
}

} // namespace raysteps
