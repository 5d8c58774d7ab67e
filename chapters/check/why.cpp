#include "why.h"

#include "mirror/left_out.h"
#include "reference/exact.h"

#include <fmt/core.h>

#include <cmath>

namespace raysteps {

namespace {

std::string of_exact_arithmetic(const ExactIntersection& exact) {
    return exact.hit ? fmt::format("By exact arithmetic the ray meets the triangle at t = {:.9g}, "
                                   "u = {:.6g}, v = {:.6g}.\n",
                                   exact.t, exact.u, exact.v)
                     : fmt::format("By exact arithmetic the ray does not meet the triangle: it "
                                   "passes at {:.3g} of a height outside its nearest edge, or "
                                   "beyond t_min or t_max.\n",
                                   exact.margin);
}

} // namespace

std::string why_not(const BoxTree& tree, std::span<const glm::vec3> corners, const Ray& ray,
                    std::int32_t triangle) {
    const auto own = corners.subspan(3 * static_cast<std::size_t>(triangle), 3);
    const ExactIntersection exact = exact_intersection(ray, {own[0], own[1], own[2]});
    const SoughtTriangle sought{
        triangle, exact.hit ? std::nextafter(static_cast<float>(exact.t), ray.t_max) : ray.t_max,
        exact.hit || exact.margin < edge_share};
    const LeftOut out =
        left_out(tree, paths_of(tree, corners.size() / 3), corners, ray, sought.t_max, triangle);
    std::string text = of_exact_arithmetic(exact);
    for (const std::string& line : left_out_in_words(out, tree, ray, sought)) {
        text += line + "\n";
    }
    return text;
}

} // namespace raysteps
