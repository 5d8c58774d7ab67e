#pragma once

#include "structure/structure_family.h"

namespace raysteps {

// All families there are: each file family_NAME.cpp of this folder defines one, and CMake writes
// the list. So a chapter adds a structure by adding files.
std::vector<StructureFamily> list_families();

// The family that serves the structure of that name. Throws InputError where none does.
StructureFamily family_of(const std::string& structure);

} // namespace raysteps
