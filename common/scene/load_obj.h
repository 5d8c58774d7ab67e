#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string_view>

namespace raysteps {

// Loads an OBJ file and the MTL files that it names. Fills everything but lights, camera and
// background: name is the file's stem, and messages say in whole sentences what was corrected,
// dropped or made up. Polygons become triangles in place, in the order of the file.
// Throws InputError, with file and line, where no honest scene can be made of it; nothing else.
Scene load_obj(const std::filesystem::path& path);

// The same, of an OBJ file's text. The path names the file in sentences, and its folder is where the
// MTL files are looked for.
Scene parse_obj(std::string_view text, const std::filesystem::path& path);

} // namespace raysteps
