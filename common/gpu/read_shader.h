#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raysteps {

// Which part fills which slot: {"triangle", "geometry/triangle_watertight.glsl"} puts that file
// where a pass says `#include <triangle>`. Paths start at the shader folder.
using Parts = std::map<std::string, std::string>;

// A whole shader. Its `#line` directives number line 12 of files[3] as 300012: GLSL can name files
// by a number of its own, but Mesa 22 loses that number in most of its messages.
inline constexpr int lines_per_file = 100000;

struct ShaderText {
    std::string text;
    std::vector<std::string> files;
};

// The folder of the shaders: a program reads them anew at each start, so that an edited shader
// needs no compiler of C++.
std::filesystem::path shader_folder();

// Reads a pass and all that it includes: `#include "layout/ray.glsl"` names a file, `#include
// <slot>` a slot. Throws MachineError with file and line where a file is missing, a slot is not in
// parts, or files include each other in a circle.
ShaderText read_shader(const std::string& pass, const Parts& parts,
                       const std::filesystem::path& folder = shader_folder());

// A compiler's messages with their numbers replaced by files and lines: `geometry/box.glsl:12:
// ...`. Knows the notations of Mesa, NVIDIA, and of AMD, Apple and glslang.
std::string name_files(const std::string& messages, const std::vector<std::string>& files);

} // namespace raysteps
