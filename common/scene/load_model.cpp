#include "scene/load_model.h"

#include "scene/import/load_import.h"
#include "scene/obj/load_obj.h"
#include "scene/ply/load_ply.h"

#include <algorithm>

namespace raysteps {

namespace {

std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& character : ending) {
        if (character >= 'A' && character <= 'Z') {
            character = static_cast<char>(character - 'A' + 'a');
        }
    }
    return ending;
}

bool is_imported(const std::string& ending) {
    const std::vector<std::string>& endings = imported_endings();
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

} // namespace

bool is_model_path(const std::filesystem::path& path) {
    const std::string ending = ending_of(path);
    return ending == ".obj" || ending == ".ply" || is_imported(ending);
}

std::string scene_endings() {
    std::string text = ".obj, .ply, ";
    for (const std::string& ending : imported_endings()) {
        text += ending + ", ";
    }
    return text + "or .toml";
}

Scene load_model(const std::filesystem::path& path, Origin origin) {
    const std::string ending = ending_of(path);
    if (ending == ".ply") {
        return load_ply(path, origin);
    }
    return is_imported(ending) ? load_import(path, origin) : load_obj(path, origin);
}

} // namespace raysteps
