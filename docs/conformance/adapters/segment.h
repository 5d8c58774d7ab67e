#pragma once

#include "suite_files.h"

#include <algorithm>
#include <array>
#include <cmath>

// For engines that take segments: a ray's part from t_min to where it has surely left the scene.
namespace suite {

using Point = std::array<double, 3>;

class Segments {
public:
    explicit Segments(const std::vector<Triangle>& triangles) {
        for (const Triangle& triangle : triangles) {
            for (const auto& corner : triangle.corners) {
                for (int axis = 0; axis < 3; ++axis) {
                    lower_[axis] = std::min(lower_[axis], static_cast<double>(corner[axis]));
                    upper_[axis] = std::max(upper_[axis], static_cast<double>(corner[axis]));
                }
            }
        }
    }

    double end_of(const AimedRay& ray) const {
        double farthest = 0.0;
        double longest = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            farthest += std::max(std::abs(upper_[axis] - ray.origin[axis]),
                                 std::abs(lower_[axis] - ray.origin[axis]));
            longest = std::max(longest, std::abs(static_cast<double>(ray.direction[axis])));
        }
        return std::min(static_cast<double>(ray.t_max), 1.01 * farthest / longest);
    }

private:
    Point lower_{1e300, 1e300, 1e300};
    Point upper_{-1e300, -1e300, -1e300};
};

inline Point point_at(const AimedRay& ray, double t) {
    return {ray.origin[0] + t * ray.direction[0], ray.origin[1] + t * ray.direction[1],
            ray.origin[2] + t * ray.direction[2]};
}

} // namespace suite
