#pragma once

#include "scene/obj/obj_file.h"
#include "scene/scene.h"

#include <filesystem>
#include <string_view>

namespace raysteps {

// Loads a PLY file (Turk, "The PLY Polygon File Format", 1994), ASCII or binary of either byte
// order, with its coordinates in double: scans in map coordinates have them. Of a vertex it takes
// x, y, z, nx, ny, nz, a texture coordinate and a colour; of a face or of strips of triangles
// the vertices. Everything else is told. Fills what load_obj fills, and throws as it does.
Scene load_ply(const std::filesystem::path& path, Origin origin = Origin::of_file);

// The same, of a PLY file's bytes. The path names the file in sentences, and its folder is where
// the picture is looked for that a comment TextureFile names.
Scene parse_ply(std::string_view bytes, const std::filesystem::path& path,
                Origin origin = Origin::of_file);

} // namespace raysteps
