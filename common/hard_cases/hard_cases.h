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

} // namespace raysteps
