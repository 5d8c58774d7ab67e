#pragma once

#include "knob.h"
#include "basics/ray.h"
#include "reference/exact.h"

#include <glm/vec3.hpp>

#include <span>

namespace raysteps {

// The distance from |value| to the next greater float.
double unit_in_last_place(double value);

// Compares hits with the true ones, ray by ray. A hit at the true triangle, or at one that has a
// corner in common with it, is right: the error of its t is taken, in ulp of the true t. (Which of
// two neighbours a ray at their edge belongs to is no question of accuracy.) Where there should be
// a hit and there is none, or one farther on, it was missed. Where there should be none, or the one
// found lies nearer than the true one, it is false.
//
// A ray that passes the outline of the mesh more closely than rounding can tell is another matter.
// With the padding of structure/padding.h as the measure: a false hit that lies so near to its
// triangle, and a wrong answer that changes when the ray is moved so far aside, are no faults, and
// are counted by themselves. At an edge between two faces that look the same way, a moved ray still
// hits, so a ray that slips through is a fault. (Padding is what structures give every triangle, by
// what the test with exact areas can promise: docs/numerics.md.)
Findings judge_hits(std::span<const Ray> rays, std::span<const Hit> hits,
                    std::span<const ReferenceHit> truth, std::span<const glm::vec3> corners);

} // namespace raysteps
