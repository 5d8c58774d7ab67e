#include "structure/reach.h"

#include "geometry/box.h"

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

float reach_of(const Box& origins, const Box& corners) {
    float reach = 0.0f;
    if (is_empty(origins) || is_empty(corners)) {
        return reach;
    }
    for (int axis = 0; axis < 3; ++axis) {
        reach = std::max({reach, std::abs(corners.upper[axis] - origins.lower[axis]),
                          std::abs(corners.lower[axis] - origins.upper[axis])});
    }
    return std::nextafter(reach, std::numeric_limits<float>::max());
}

} // namespace

float reach_of(const glm::vec3& point, std::span<const glm::vec3> corners) {
    return reach_of(Box{point, point}, bounds_of(corners));
}

float reach_of(std::span<const Ray> rays, std::span<const glm::vec3> corners) {
    Box origins;
    for (const Ray& ray : rays) {
        origins = merge(origins, ray.origin);
    }
    return reach_of(origins, bounds_of(corners));
}

} // namespace raysteps
