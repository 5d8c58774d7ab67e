#pragma once

#include "basics/ray.h"

#include <glm/vec3.hpp>

#include <array>
#include <limits>

namespace raysteps {

inline constexpr float infinity = std::numeric_limits<float>::infinity();

inline const std::array<glm::vec3, 3> unit_triangle{glm::vec3(0, 0, 0), glm::vec3(1, 0, 0),
                                                    glm::vec3(0, 1, 0)};

// Straight down from height 2 onto the plane of the unit triangle.
inline Ray down_at(float x, float y) {
    return {{x, y, 2.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, infinity};
}

} // namespace raysteps
