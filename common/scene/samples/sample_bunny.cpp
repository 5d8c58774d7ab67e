#include "scene/sample_bunny.h"

#include "error/error.h"
#include "scene/load_obj.h"

#include <filesystem>
#include <system_error>

namespace raysteps {

Scene sample_bunny() {
    const std::filesystem::path path = "/usr/share/glmark2/models/bunny.obj";
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        throw InputError("bunny: " + path.string() +
                         " is not there. Install the package glmark2-data.");
    }
    Scene scene = load_obj(path);
    // It is known by its name, like the other samples, and so is what its file lacks.
    scene.models.clear();
    scene.messages.clear();
    return scene;
}

} // namespace raysteps
