#pragma once

#include "scene/obj_file.h"
#include "scene/scene.h"

#include <vector>

namespace raysteps {

// The scene that an OBJ file and the materials of its MTL files make: polygons cut into triangles
// in place, a normal of unit length at each corner, and messages on what was dropped or made up. Of
// materials with one name, the first counts; a triangle whose name has none gets a default.
Scene make_scene(const ObjFile& file, std::vector<Material> materials);

} // namespace raysteps
