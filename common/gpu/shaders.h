#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raysteps {

// Where a shader file is read from: the first of the folders that the environment variable
// RAYSTEPS_SHADERS names, with colons between them, that has the file; else the given folder. So a
// person's own version of a part takes the place of the project's, and nothing is edited.
std::filesystem::path find_shader(const std::string& file, const std::filesystem::path& folder);

// Which part fills which slot: {"triangle", "triangle/watertight.glsl"} puts that file
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

// Reads a pass and all that it includes: `#include "core/ray.glsl"` names a file, `#include
// <slot>` a slot. Throws MachineError with file and line where a file is missing, a slot is not in
// parts, or files include each other in a circle.
ShaderText read_shader(const std::string& pass, const Parts& parts,
                       const std::filesystem::path& folder = shader_folder());

// A compiler's messages with their numbers replaced by files and lines: `core/ray.glsl:12:
// ...`. Knows the notations of Mesa, NVIDIA, and of AMD, Apple and glslang.
std::string name_files(const std::string& messages, const std::vector<std::string>& files);

// A part that can fill a slot, by its name on the command line.
struct NamedPart {
    std::string name; // watertight
    std::string file; // triangle/watertight.glsl
};

// The file of the pass NAME.frag, in whichever folder of shaders/pass it is. Throws MachineError.
std::string find_pass(const std::string& name);

// A pass with a part in each of its slots.
struct ProgramRecipe {
    std::string pass;
    Parts parts;
};

// The shader folder is its own catalogue, so that a new part is a new file and nothing else. The
// slot <triangle> takes each file in the folder triangle/ that defines what the slot needs, and the
// slots <structure> and <packet> share the folder structure/. Sorted by name.
std::vector<NamedPart> list_parts(const std::string& slot);

// The file of the part with that name. Throws InputError that lists the names where there is none.
std::string find_part(const std::string& slot, const std::string& name);

// The file of the fragment pass with that name: pass/light/reflect.frag of `reflect`, whichever
// folder of shaders/pass it is in. Throws MachineError where there is none.
std::string find_pass(const std::string& name);

// Every program that the project can compose: each fragment pass with each choice of parts.
std::vector<ProgramRecipe> list_programs();

} // namespace raysteps
