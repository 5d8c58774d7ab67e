#pragma once

#include "hard_cases/hard_case.h"
#include "basics/random_numbers.h"

namespace raysteps {

// Scenes and rays of random bits, for fuzzing. Each seed makes one, the same everywhere.

// Up to 60 triangles within the promises of docs/numerics.md, and as awkward as can be there:
// coordinates on a lattice, shared, one bit apart, thousands of times as large as others;
// slivers, points, copies. Rays at corners and edges, in planes, along axes, with zeros and with
// ends that lie at hits. Structures are built with random options. Every structure must find the
// bits of the loop.
HardScene awkward_scene(int seed);

// The same, but any coordinate and any number of a ray may have any bits at all. A builder may
// refuse it; a walk must answer.
HardScene garbage_scene(int seed);

// Whether every coordinate is finite: a builder must refuse any other scene.
bool is_finite(const Mesh& mesh);

} // namespace raysteps
