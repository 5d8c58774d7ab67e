#pragma once

#include "reference/surface.h"

#include <vector>

namespace raysteps {

// Optics of clear bodies, in double, from the textbook's formulas by angles.

// The part of unpolarised light that a surface between media of these indices reflects, by the
// angle between ray and normal; 1 where the reflection is total. (Hecht, "Optics", 5th ed., 2017,
// equations 4.34 and 4.40.)
double fresnel_by_angle(double angle, double index_before, double index_behind);

// The part of the light that a material lets through, as its MTL statements d and illum say.
double clear_part(const Material& material);

// Materials of the bodies that a ray is inside of, the innermost last.
using Bodies = std::vector<const Material*>;

// What a ray passes from and to at a surface of that material; `outside` where it meets the outer
// side.
struct Passage {
    Bodies before;
    Bodies behind;
};

Passage passage(const Bodies& inside, const Material* material, bool outside);

// Of air, 1, where the ray is inside of nothing.
double index_of(const Bodies& bodies);

// What absorption leaves after so much of a way (Beer's law).
glm::dvec3 left_after(const Material& material, double distance);

} // namespace raysteps
