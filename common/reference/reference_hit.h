#pragma once

#include "geometry/layout.h"

namespace raysteps {

// Where a ray first meets triangles: at origin + t * direction, which is
// (1 - u - v) * a + u * b + v * c. Of a miss, t is the ray's t_max and the triangle no_triangle.
struct ReferenceHit {
    double t = 0.0;
    double u = 0.0;
    double v = 0.0;
    int triangle = no_triangle;
};

} // namespace raysteps
