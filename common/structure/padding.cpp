#include "structure/padding.h"

#include "basics/error.h"

#include <fmt/format.h>

#include "basics/box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raysteps {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Where nothing has an extent, the padding must not be zero all the same.
constexpr double least_reach = 0x1p-100;

float at_most(double value) {
    const auto rounded = static_cast<float>(value);
    return std::nextafter(rounded, -infinity);
}

float at_least(double value) {
    const auto rounded = static_cast<float>(value);
    return std::nextafter(rounded, infinity);
}

} // namespace

double padding_for(double reach) {
    return 0x1p-19 * std::max(reach, least_reach); // 32 e = 2^5 * 2^-24
}

double usual_reach(const Box& bounds, double asked) {
    if (is_empty(bounds)) {
        return asked;
    }
    double side = 0.0;
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double lower = bounds.lower[axis];
        const double upper = bounds.upper[axis];
        side = std::max(side, upper - lower);
        largest = std::max({largest, std::abs(lower), std::abs(upper)});
    }
    // Twice the 64 e, which leaves room for the rounding of the point itself.
    return std::max({4.0 * side, side + 0x1p-17 * largest, asked});
}

Box pad(const Box& box, double padding) {
    Box padded;
    for (int axis = 0; axis < 3; ++axis) {
        padded.lower[axis] = at_most(static_cast<double>(box.lower[axis]) - padding);
        padded.upper[axis] = at_least(static_cast<double>(box.upper[axis]) + padding);
    }
    return padded;
}

float reach_of(const Box& origins, std::span<const glm::vec3> corners) {
    float reach = 0.0f;
    if (is_empty(origins) || corners.empty()) {
        return reach;
    }
    const Box bounds = bounds_of(corners);
    for (int axis = 0; axis < 3; ++axis) {
        reach = std::max({reach, std::abs(bounds.upper[axis] - origins.lower[axis]),
                          std::abs(bounds.lower[axis] - origins.upper[axis])});
    }
    return std::nextafter(reach, std::numeric_limits<float>::max());
}

float reach_of(std::span<const Ray> rays, std::span<const glm::vec3> corners) {
    Box origins;
    for (const Ray& ray : rays) {
        origins = merge(origins, ray.origin);
    }
    return reach_of(origins, corners);
}

void check_corners(std::span<const glm::vec3> corners, float greatest) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::abs(corners[i][axis]) <= greatest)) { // NaN is not
                throw InputError(fmt::format("Triangle {} has a corner that is not finite or lies "
                                             "beyond {:.3g}. Fix the model.",
                                             i / 3, greatest));
            }
        }
    }
}

} // namespace raysteps
