#pragma once

#include "scene/obj_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raysteps {

inline constexpr std::uintmax_t most_mtl_bytes = std::uintmax_t{8} << 20;

struct MtlFile {
    std::filesystem::path path;
    std::string text;
};

struct MtlFiles {
    std::vector<MtlFile> files;
    Findings findings; // about the OBJ file that names them
};

// The material files that an OBJ file names, each once. One that is missing, too large, or outside
// the folder of the OBJ file is left out with a finding: the shape can be shown without its
// colours.
MtlFiles read_mtl_files(const ObjFile& file);

} // namespace raysteps
