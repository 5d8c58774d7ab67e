#pragma once

#include "hard_cases/hard_case.h"
#include "scene/scene.h"

namespace raysteps {

// All hard cases that are a mesh and rays, by sections: P, T, G, K, V, D.
const std::vector<HardCase>& hard_cases();

// The case of that name; capitals do not matter. Throws InputError that lists the names where there
// is none.
const HardCase& find_hard_case(const std::string& name);

// The case's mesh in grey, with a camera that sees it all and lights: for a picture. Throws
// InputError where the mesh is too large for a camera to stand back from.
Scene scene_of(const HardCase& hard_case, const HardScene& made, float aspect_ratio);

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
