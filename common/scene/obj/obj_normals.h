#pragma once

#include "scene/obj_file.h"

#include <span>
#include <string>
#include <vector>

namespace raysteps {

// Where a corner of a triangle comes from.
struct CornerOrigin {
    ObjCorner corner;
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
