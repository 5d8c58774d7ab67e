#pragma once

#include "scene/place_camera.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace raysteps {

// What is asked of a scene from a file besides its name.
struct SceneRequest {
    int scale_exponent = 0; // all its lengths are multiplied by 2 to this power
    CameraRequest camera{}; // where it names none
};

// Loads what --scene names: a sample scene (`cornell_box`, `sphereflake:3`), `bunny`, or the path
// of a model (load_model.h) or a .toml file. The aspect ratio (width / height) lets the camera
// frame a bare model. Throws InputError with file and line where it cannot be used.
Scene load_scene(const std::string& name, float aspect_ratio, const SceneRequest& request = {});

// The scene as the text of a TOML scene file that load_scene reads back to the same scene.
// A sample scene is named by its name.
std::string to_toml(const Scene& scene);

// A line for each name that load_scene takes besides files.
std::string list_scenes();

// The scene of a TOML scene file's text (docs/scene_files.md). The path names the file in
// sentences, and the models' paths start in its folder. The aspect ratio is width / height, over 0.
// Throws InputError with file, line and column.
Scene read_toml_scene(std::string_view text, const std::filesystem::path& path, float aspect_ratio,
                      const SceneRequest& request = {});

} // namespace raysteps
