#pragma once

#include "scene/obj/obj_checks.h"
#include "scene/obj/obj_file.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// The folder that a file stands in; "." where the path names none.
std::filesystem::path folder_of(const std::filesystem::path& file);

// Where a file that is named in another file stands: the name, seen from the folder `from`.
// Nothing where that is outside the folder `inside`, also by way of a symbolic link. A backslash
// counts as a slash, since files from Windows are full of them. The file need not exist.
std::optional<std::filesystem::path> path_inside(const std::filesystem::path& inside,
                                                 const std::filesystem::path& from,
                                                 std::string_view name);

// The path of the texture that a material names, or a message why it is left out.
struct MtlTexture {
    std::string path;
    std::string message;
};

// The name is seen from the folder of the MTL file. Where there is no such file, those of its last
// word beside the MTL file, and in `textures` there, are tried, since names of another machine's
// folders are common. A texture outside the folder `inside` is left out; one that is not there
// keeps its path, so that opening it reports it. The message names every place that was tried.
MtlTexture find_texture(const std::string& name, const std::filesystem::path& mtl_path,
                        const std::filesystem::path& inside);

// The values of one MTL statement that is a number or a colour, brought into their range.
struct MtlValues {
    std::string statement;  // with a line end; empty where the values cannot be corrected
    std::string correction; // a sentence without its full stop; empty where nothing was wrong
};

// Is the keyword that of a number or a colour: Kd, Ks, Ke, Kt, Tf, Ns, Ni, d, Tr or illum?
bool has_mtl_values(std::string_view keyword);

// The words of such a statement, keyword first. Tr comes back as d, and Kt as Tf. One value for a
// colour is a grey.
MtlValues checked_mtl_values(const std::vector<std::string_view>& words);

// All statements that make the material, so that no default is left to the reader.
std::string to_mtl(const Material& material);

struct CleanMtl {
    std::string text;
    ObjFindings findings;
};

// An MTL text in which every value is usable and every default is written out, since tinyobjloader
// lets through Ni 0, d 2 and nan, makes `Kd 0.5` (a grey) red, and has other defaults than
// Material. Reflectances and opacity are brought to between 0 and 1, exponents (Ns) to at most 1e6;
// a line that cannot be corrected is left out. The text is empty where it holds no material.
CleanMtl clean_mtl(std::string_view text);

inline constexpr std::uintmax_t most_mtl_bytes = std::uintmax_t{8} << 20;

struct MtlFile {
    std::filesystem::path path;
    std::string text;
};

struct MtlFiles {
    std::vector<MtlFile> files;
    ObjFindings findings; // about the OBJ file that names them
};

// The material files that an OBJ file names, each once. One that is not where it is said to be is
// looked for by its last word in the folder of the OBJ file, and then by the name of the OBJ file.
// One that is missing, too large, or outside the folder of the OBJ file is left out with a finding:
// the shape can be shown without its colours.
MtlFiles read_mtl_files(const ObjFile& file);

} // namespace raysteps
