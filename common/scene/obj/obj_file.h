#pragma once

#include "scene/obj_findings.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace raysteps {

inline constexpr int not_given = -1;

// A corner of a face: indices into the lists of its file, counted from 0, or not_given.
struct ObjCorner {
    int position = not_given;
    int texture_coordinate = not_given;
    int normal = not_given;
};

// Owns the corners [first_corner, first_corner + corner_count). Smoothing group 0 is flat.
struct ObjFace {
    std::int64_t line = 0;
    std::size_t first_corner = 0;
    int corner_count = 0;
    int material_name = not_given;
    int smoothing_group = 0;
};

// The name of a material file, and the line that asks for it.
struct ObjLibrary {
    std::string name;
    std::int64_t line = 0;
};

// What an OBJ file says, before anything is made of it. Every coordinate is finite, and every index
// of a corner is in range. A normal is zero where the file gave none that has a direction.
struct ObjFile {
    std::filesystem::path path;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> texture_coordinates;
    std::vector<glm::vec3> normals;
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<std::string> material_names;
    std::vector<ObjLibrary> libraries;
    Findings findings;
};

} // namespace raysteps
