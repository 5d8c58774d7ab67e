#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace raysteps {

// Loads what --scene names: a sample scene (`cornell_box`, `sphereflake:3`), `bunny`, or the path
// of an .obj or .toml file. The aspect ratio (width / height) lets the camera frame a bare model;
// one that is too large for that gets the camera `instead`, where there is one. Throws InputError
// with file and line where it cannot be used.
Scene load_scene(const std::string& name, float aspect_ratio,
                 const std::optional<Camera>& instead = std::nullopt);

// The scene as the text of a TOML scene file that load_scene reads back to the same scene.
// A sample scene is named by its name.
std::string to_toml(const Scene& scene);

// A line for each name that load_scene takes besides files.
std::string list_scenes();

// The scene of a TOML scene file's text (docs/scene_files.md). The path names the file in
// sentences, and the models' paths start in its folder. The aspect ratio is width / height, over 0;
// the camera `instead` is as load_scene's. Throws InputError with file, line and column.
Scene read_toml_scene(std::string_view text, const std::filesystem::path& path, float aspect_ratio,
                      const std::optional<Camera>& instead = std::nullopt);

} // namespace raysteps
