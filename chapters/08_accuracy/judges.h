#pragma once

#include "basics/ray.h"
#include "image/image.h"
#include "reference/exact_mesh.h"
#include "trade_off.h"

#include <glm/vec3.hpp>

#include <span>

namespace raysteps {

// The distance from |value| to the next greater float.
double unit_in_last_place(double value);

// The name of the fault that is a hit lost. On a closed mesh, it is a leak.
inline const std::string missed_hit = "missed";

// Compares hits with the true ones, ray by ray. A hit at the true triangle is right: the error of
// its t is taken, in ulp of the true t. So is one at a neighbour, a triangle that has a corner in
// common with the true one, if the ray cannot be told to miss it: if exact arithmetic puts the two
// at the same t, but for what the padding below makes of it (judges.cpp derives the bound). The
// error is that from the neighbour's own exact t. (Which of two neighbours a ray at their edge
// belongs to is no question of accuracy. But a ray that leaks through an edge, and meets a
// neighbour from behind, farther on, has missed.) Where there should be
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
                    std::span<const ReferenceHit> truth, const ExactMesh& mesh);

// How far a picture is from the true one: pixels that differ by more than one of the 256 steps of
// sRGB are faults; the error is that of each pixel in such steps, of the component that differs
// most; beside it stand the RMSE of the linear colours and the structural similarity.
Findings judge_picture(const Image& picture, const Image& truth);

// Where two pictures differ: the first one in grey, and red where they do by more than one step.
Image mark_differences(const Image& picture, const Image& truth);

// How alike two pictures look, by brightness, contrast and pattern in windows of 8 x 8 pixels: 1 is
// the same, 0 has nothing in common. Of the brightness as sRGB shows it (which is about even to the
// eye), the mean over windows that overlap by half. Pictures of equal size, 8 pixels wide and high
// at least; throws InputError else. Source: Wang, Bovik, Sheikh and Simoncelli, "Image Quality
// Assessment: From Error Visibility to Structural Similarity", 2004.
double structural_similarity(const Image& a, const Image& b);

} // namespace raysteps
