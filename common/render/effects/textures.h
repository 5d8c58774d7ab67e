#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace raysteps {

// A picture made by code, for surfaces of sample scenes: `made:checker`, `made:bricks`, `made:wood`
// or `made:globe`. Throws InputError where there is none of that name.
Image made_picture(const std::string& name);

// Whether the name is one that made_picture is asked for.
bool is_made_picture(const std::string& name);

// The picture and its coarser levels: each half as wide and half as high as the last, rounded down,
// at least 1, until a single texel. A texel is the mean of the finer ones that it covers.
// Source: Williams, "Pyramidal parametrics", 1983.
std::vector<Image> picture_pyramid(const Image& picture);

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
