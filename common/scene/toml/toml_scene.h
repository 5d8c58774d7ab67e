#pragma once

#include "scene/scene.h"

#include <glm/mat4x4.hpp>
#include <toml++/toml.h>

#include <filesystem>
#include <string_view>
#include <vector>

namespace raysteps {

// Where a [[model]] stands: its `matrix`, or its `scale`, then `rotate`, then `translate`.
// Throws InputError with file, line and column; also for a transform that flattens the model.
glm::mat4 toml_transform(const toml::table& model);

// What a scene file says of its camera, its lights and its background. All of these throw
// InputError with file, line and column.
Camera toml_camera(const toml::node& camera);
std::vector<Light> toml_lights(const toml::node& lights);
Sky toml_sky(const toml::node& sky);
glm::vec3 toml_color(const toml::node& color, std::string_view key);

// The scene of a TOML scene file's text (docs/scene_files.md). The path names the file in
// sentences, and the models' paths start in its folder. The aspect ratio is width / height, over 0.
// Throws InputError with file, line and column.
Scene read_toml_scene(std::string_view text, const std::filesystem::path& path, float aspect_ratio);

} // namespace raysteps
