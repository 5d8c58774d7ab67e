#pragma once

#include "catch.h"
#include "reference/brute_force.h"
#include "unit_triangle.h"

#include <vector>

namespace raysteps {

using Corners = std::vector<glm::vec3>;

// Whether brute force in double finds a hit; nearest and any must always agree.
inline bool is_hit(const Ray& ray, const Corners& corners) {
    const bool nearest = nearest_hit(ray, corners).triangle != no_triangle;
    REQUIRE(any_hit(ray, corners) == nearest);
    return nearest;
}

inline bool is_hit_on_unit_triangle(const Ray& ray) {
    return is_hit(ray, Corners(unit_triangle.begin(), unit_triangle.end()));
}

} // namespace raysteps
