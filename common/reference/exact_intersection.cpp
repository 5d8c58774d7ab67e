#include "reference/exact_intersection.h"

#include "reference/exact_solution.h"

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

bool is_finite(const std::array<glm::vec3, 3>& corners) {
    return std::all_of(corners.begin(), corners.end(), [](const glm::vec3& corner) {
        return std::isfinite(corner.x) && std::isfinite(corner.y) && std::isfinite(corner.z);
    });
}

} // namespace

ExactIntersection exact_intersection(const Ray& ray, const std::array<glm::vec3, 3>& corners) {
    if (!is_usable(ray) || !is_finite(corners)) {
        return {};
    }
    const ExactSolution solution = solve_exactly(ray, corners);
    if (!solution.unique) {
        return {};
    }
    const double u = nearest_double(solution.u);
    const double v = nearest_double(solution.v);
    const double w = nearest_double(solution.w);
    return {is_hit(solution, ray), nearest_double(solution.t), u, v, std::abs(std::min({u, v, w}))};
}

} // namespace raysteps
