#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string_view>

namespace raysteps {

// The scene of a TOML scene file's text (docs/scene_files.md). The path names the file in
// sentences, and the models' paths start in its folder. The aspect ratio is width / height, over 0.
// Throws InputError with file, line and column.
Scene read_toml_scene(std::string_view text, const std::filesystem::path& path, float aspect_ratio);

} // namespace raysteps
