#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>
#include <span>

namespace raysteps {

inline bool is_finite(const glm::vec3& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

// An axis-aligned box, closed on every side. The default is the empty box: merging it changes
// nothing.
struct Box {
    glm::vec3 lower{+std::numeric_limits<float>::infinity()};
    glm::vec3 upper{-std::numeric_limits<float>::infinity()};
};

inline bool is_finite(const Box& box) {
    return is_finite(box.lower) && is_finite(box.upper);
}

inline bool is_empty(const Box& box) {
    return box.lower.x > box.upper.x || box.lower.y > box.upper.y || box.lower.z > box.upper.z;
}

inline Box merge(const Box& box, const glm::vec3& point) {
    return {glm::min(box.lower, point), glm::max(box.upper, point)};
}

inline Box merge(const Box& a, const Box& b) {
    return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)};
}

// The surface of a box that is not empty, from its corners of three numbers or more. In double,
// since the product of two sides of 1e30 is no float any more.
template <class Corner>
double surface_between(const Corner& lower, const Corner& upper) {
    const double x = static_cast<double>(upper[0]) - static_cast<double>(lower[0]);
    const double y = static_cast<double>(upper[1]) - static_cast<double>(lower[1]);
    const double z = static_cast<double>(upper[2]) - static_cast<double>(lower[2]);
    return 2.0 * (x * y + y * z + z * x);
}

// The surface of the box; 0 where it is empty.
inline double surface_area(const Box& box) {
    return is_empty(box) ? 0.0 : surface_between(box.lower, box.upper);
}

// The smallest box that holds all points; empty where there are none.
inline Box bounds_of(std::span<const glm::vec3> points) {
    Box box;
    for (const glm::vec3& point : points) {
        box = merge(box, point);
    }
    return box;
}

} // namespace raysteps
