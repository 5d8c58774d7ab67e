#include "scene/import/importer/import_file.h"

#include "basics/error.h"

namespace raysteps {

MeshFile import_file(const std::string&) {
    throw MachineError("files of this kind are read by Assimp, without which this program was "
                       "built. Install the package libassimp-dev and build again, or give an .obj "
                       "or .ply file.");
}

} // namespace raysteps
