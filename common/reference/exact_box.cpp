#include "reference/exact_box.h"

#include "reference/exact_solution.h"

#include <vector>

namespace raysteps {

namespace {

// The distance along the ray to a plane, times the unit of the distance itself.
Fraction crossing(const Ray& ray, int axis, float plane) {
    Integer numerator = in_units(plane) - in_units(ray.origin[axis]);
    Integer denominator = in_units(ray.direction[axis]);
    if (denominator < 0) {
        numerator = -numerator;
        denominator = -denominator;
    }
    return {numerator, denominator};
}

} // namespace

bool exact_meets_box(const Ray& ray, const Box& box) {
    std::vector<Fraction> entries{{in_units(ray.t_min), in_units(1.0f)}};
    std::vector<Fraction> exits;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0f) {
            if (ray.origin[axis] < box.lower[axis] || ray.origin[axis] > box.upper[axis]) {
                return false;
            }
            continue;
        }
        const bool up = ray.direction[axis] > 0.0f;
        entries.push_back(crossing(ray, axis, up ? box.lower[axis] : box.upper[axis]));
        exits.push_back(crossing(ray, axis, up ? box.upper[axis] : box.lower[axis]));
    }
    for (const Fraction& exit : exits) {
        for (const Fraction& entry : entries) {
            if (is_less(exit, entry)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace raysteps
