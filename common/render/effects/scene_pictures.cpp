#include "effects/scene_pictures.h"

#include "effects/made_pictures.h"
#include "error/error.h"
#include "image/read_picture.h"
#include "scene/material_effects.h"

#include <map>

namespace raysteps {

namespace {

constexpr int no_picture = -1;

Image load_picture(const std::string& name) {
    return is_made_picture(name) ? made_picture(name) : read_picture(name);
}

} // namespace

ScenePictures load_pictures(const Scene& scene) {
    ScenePictures result;
    std::map<std::string, int> number_of_name;
    for (const Material& material : scene.materials) {
        if (!has_picture(material)) {
            result.number_of_material.push_back(no_picture);
            continue;
        }
        const auto [entry, is_new] = number_of_name.try_emplace(
            material.diffuse_map, static_cast<int>(number_of_name.size()));
        if (is_new) {
            entry->second = no_picture;
            try {
                result.pictures.push_back(load_picture(material.diffuse_map));
                entry->second = static_cast<int>(result.pictures.size()) - 1;
            } catch (const InputError& error) {
                result.messages.push_back("Material " + material.name +
                                          ": its picture is left out. " + error.what());
            }
        }
        result.number_of_material.push_back(entry->second);
    }
    return result;
}

} // namespace raysteps
