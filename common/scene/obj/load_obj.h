#pragma once

#include "scene/obj/obj_file.h"
#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace raysteps {

inline constexpr std::uintmax_t most_obj_bytes = std::uintmax_t{4} << 30;

// Loads an OBJ file and the MTL files that it names. Fills everything but lights, camera and
// background: name is the file's stem, and messages say in whole sentences what was corrected,
// dropped or made up. Polygons become triangles in place, in the order of the file.
// Throws InputError, with file and line, where no honest scene can be made of it, and MachineError
// where memory runs out; nothing else.
Scene load_obj(const std::filesystem::path& path, Origin origin = Origin::of_file);

// The same, of an OBJ file's text. The path names the file in sentences, and its folder is where
// the MTL files are looked for.
Scene parse_obj(std::string_view text, const std::filesystem::path& path,
                Origin origin = Origin::of_file);

struct ParsedMtl {
    std::vector<Material> materials; // in the order of the file
    std::vector<std::string> messages;
};

// The materials of an MTL file's text. The path names the file in sentences; textures are looked
// for in its folder, and left out where they are not in the folder `inside` or below it. Throws as
// load_obj does.
ParsedMtl parse_mtl(std::string_view text, const std::filesystem::path& path,
                    const std::filesystem::path& inside);

// The scene that an OBJ file and the materials of its MTL files make: polygons cut into triangles
// in place, a normal of unit length at each corner, and messages on what was dropped or made up. Of
// materials with one name, the first counts; a triangle whose name has none gets a default.
Scene make_scene(ObjFile file, std::vector<Material> materials);

} // namespace raysteps
