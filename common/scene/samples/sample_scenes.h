#pragma once

#include "scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// A whole number that a sample scene takes.
struct SampleParameter {
    std::string_view name;
    int lowest = 0;
    int highest = 0;
    int usual = 0;
};

enum class SampleView {
    its_own, // the scene brings its camera and its lights
    framed,  // they are placed so that the whole scene is seen
};

// A scene made by code. `make` takes one number for each parameter, each in its range.
struct SampleScene {
    std::string_view name;
    std::vector<SampleParameter> parameters;
    SampleView view = SampleView::framed;
    Scene (*make)(const std::vector<int>& values) = nullptr;
    std::string_view description;
};

// All of them, in the order in which they are listed.
const std::vector<SampleScene>& sample_scenes();

// Whether the name, up to its first colon, is one of a sample scene.
bool is_sample_name(std::string_view name);

// The scene of a name such as `soup:1000:7`; parameters that are not given have their usual values.
// The scene's name names them all. The aspect ratio is width / height, over 0.
// Throws InputError for an unknown name, and for a parameter that is not a whole number in its
// range.
Scene make_sample_scene(std::string_view name, float aspect_ratio);

} // namespace raysteps
