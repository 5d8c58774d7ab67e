#pragma once

#include "gpu/read_shader.h"

#include <string>
#include <vector>

namespace raysteps {

// A part that can fill a slot, by the name that a person calls it.
struct NamedPart {
    std::string name; // watertight
    std::string file; // geometry/triangle_watertight.glsl
};

// A pass with a part in each of its slots.
struct ProgramRecipe {
    std::string pass;
    Parts parts;
};

// The shader folder is its own catalogue, so that a new part is a new file and nothing else. The
// slot <triangle> takes each file triangle_NAME.glsl, and each file NAME.glsl of a folder
// triangle/. Sorted by name.
std::vector<NamedPart> list_parts(const std::string& slot);

// The file of the part with that name. Throws InputError that lists the names where there is none.
std::string find_part(const std::string& slot, const std::string& name);

// Every program that the project can compose: each fragment pass with each choice of parts.
std::vector<ProgramRecipe> list_programs();

} // namespace raysteps
