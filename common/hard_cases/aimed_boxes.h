#pragma once

#include "geometry/box.h"
#include "hard_cases/ray_families.h"

namespace raysteps {

// A ray and a box of which the answer is known.
struct AimedBox {
    Ray ray;
    Box box;
    bool meets = true;
};

// Rays in the planes of a unit box's sides, along another axis, with zeros of either sign; and
// beside it by a millionth (B1).
std::vector<AimedBox> rays_in_sides_of_a_box();

// Boxes, flat along one axis or none, with a ray to one of their corners. All numbers are multiples
// of 2^-9 between -2 and 2, so the rays are exact (B2).
std::vector<AimedBox> rays_at_corners_of_any_box(RandomNumbers& numbers, int count);

// A unit box at an offset of a million and rays that pass its corner (B3).
std::vector<AimedBox> rays_far_from_zero();

// A unit box before, around and behind the origin, and rays that end at its entry or begin at its
// exit (B4).
std::vector<AimedBox> rays_that_end_at_a_box();

// The empty box, which no ray meets (B5).
std::vector<AimedBox> rays_at_the_empty_box(RandomNumbers& numbers, int count);

} // namespace raysteps
