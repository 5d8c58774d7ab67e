#pragma once

#include "scene/obj/obj_file.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// Each takes the words of one OBJ statement, keyword first, and gives back its numbers, or all of
// it in a form that tinyobjloader reads rightly, with a line end. `where` opens the sentence of an
// error.

// Three coordinates of a vertex, in double. Throws InputError where one is missing, no number, or
// greater than greatest_coordinate.
glm::dvec3 checked_position(const std::vector<std::string_view>& words, const ObjPlace& where);

// The colour behind the coordinates of a vertex, in sRGB from 0 to 1, as linear RGB; white where it
// is none.
glm::vec3 checked_color(const std::vector<std::string_view>& words);

// One or two coordinates; a third is left out. Throws InputError as for a vertex.
std::string checked_texture_coordinate(const std::vector<std::string_view>& words,
                                       const ObjPlace& where);

// Three components, all 0 where they give no direction: a surface can do without a normal.
std::string checked_normal(const std::vector<std::string_view>& words);

// Corners of the forms 1, 1/2, 1//3 and 1/2/3. Throws InputError where an index is not a whole
// number, 0, or beyond 32 bits.
std::string checked_face(const std::vector<std::string_view>& words, const ObjPlace& where);

// Where a corner of a triangle comes from.
struct CornerOrigin {
    std::uint32_t corner = 0; // of ObjFile::corners
    int smoothing_group = 0;
};

struct ObjNormals {
    std::vector<glm::vec3> normals;
    std::string message; // which normals they are
};

// A normal of unit length for each corner of triangles that have an area: the one that the file
// gives; else, in a smoothing group, one that all corners at its vertex in that group share; else
// that of the triangle. A file that says neither vn nor s is flat, as OBJ defines it.
ObjNormals make_normals(const ObjFile& file, std::span<const glm::vec3> corners,
                        std::span<const CornerOrigin> origins);

} // namespace raysteps
