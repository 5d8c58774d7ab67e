#pragma once

#include "scene/obj/obj_file.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace raysteps {

// Whether files of that ending are models: .obj, .ply, and what the importer reads.
bool is_model_path(const std::filesystem::path& path);

// ".obj, .ply, .gltf, ... or .toml", for sentences.
std::string scene_endings();

// Loads a model of any of these formats. Fills everything but camera and background, of lights
// those of the file; throws as load_obj does.
Scene load_model(const std::filesystem::path& path, Origin origin);

} // namespace raysteps
