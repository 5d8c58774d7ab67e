#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace raysteps {

// Loads what --scene names: a sample scene (`cornell_box`, `sphereflake:3`), `bunny`, or the path
// of an .obj or .toml file. The aspect ratio (width / height) lets the camera frame a bare model.
// All lengths of a file are multiplied by 2^scale_exponent (scene/scaling.h). Throws InputError
// with file and line where it cannot be used.
Scene load_scene(const std::string& name, float aspect_ratio, int scale_exponent = 0);

// The scene as the text of a TOML scene file that load_scene reads back to the same scene.
// A sample scene is named by its name.
std::string to_toml(const Scene& scene);

// A line for each name that load_scene takes besides files.
std::string list_scenes();

// The scene of a TOML scene file's text (docs/scene_files.md). The path names the file in
// sentences, and the models' paths start in its folder. The aspect ratio is width / height, over 0.
// All lengths are multiplied by 2^scale_exponent. Throws InputError with file, line and column.
Scene read_toml_scene(std::string_view text, const std::filesystem::path& path, float aspect_ratio,
                      int scale_exponent = 0);

} // namespace raysteps
