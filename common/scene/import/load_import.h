#pragma once

#include "scene/obj/obj_file.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raysteps {

// The endings of files that the importer reads, in small letters: .gltf, .glb, .stl, ...
const std::vector<std::string>& imported_endings();

// Loads a model of another format than OBJ and PLY: the importer, a program of its own (importer/),
// reads it with limits of memory and time, so that whatever goes wrong there is one sentence here.
// Fills what load_obj fills, and camera, lights and pictures of the file. Throws InputError where
// the file cannot be used, and MachineError where the importer cannot.
Scene load_import(const std::filesystem::path& path, Origin origin = Origin::of_file);

} // namespace raysteps
