#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace raysteps {

// The pictures that materials of a scene name, each once, and the number of its picture for each
// material, or -1. A picture that cannot be read is left out with a message: its material then
// shows its Kd alone.
struct ScenePictures {
    std::vector<Image> pictures;
    std::vector<int> number_of_material;
    std::vector<std::string> messages;
};

ScenePictures load_pictures(const Scene& scene);

} // namespace raysteps
