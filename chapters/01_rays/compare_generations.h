#pragma once

#include "basics/text.h"
#include "scene/scene.h"

#include <filesystem>

namespace raysteps {

// Measures both ways to make primary rays against the exact directions, prints the errors in ulp
// and the lengths of the directions, draws the errors as heat maps in one scale into the folder
// `out`, and writes the numbers.
void compare_generations(const Scene& scene, const PictureSize& size,
                         const std::filesystem::path& out, const std::filesystem::path& json);

} // namespace raysteps
