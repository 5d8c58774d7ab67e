#pragma once

#include "scene/import/mesh_file.h"

#include <string>

namespace raysteps {

// The model of the file. Throws InputError where it holds none, and MachineError where the library
// that reads it is missing; both without the file's name.
MeshFile import_file(const std::string& path);

} // namespace raysteps
