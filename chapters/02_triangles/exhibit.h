#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace raysteps {

// The paper's listing, each state of its repair beside the watertight test: a picture, and how many
// pixels it gets wrong, at the scene's own size and at a thousandth of it. The picture goes to the
// folder `out`.
void show_exhibit(const Scene& scene, const std::filesystem::path& out,
                  const std::filesystem::path& json);

} // namespace raysteps
