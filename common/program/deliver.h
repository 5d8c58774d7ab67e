#pragma once

#include "program/command.h"
#include "image/image.h"
#include "program/window/show_in_window.h"

#include <nlohmann/json.hpp>

#include <string>

namespace raysteps {

// With --window: shows the picture in the window, rendering it anew as the camera moves, until the
// window is closed. Else renders it once, writes NAME.png (sRGB) and NAME.pfm (linear floats) to
// the folder of --out, and says so.
void deliver(const Command& command, Context& context, const Camera& camera,
             const std::string& name, const RenderPicture& render);

// Writes NAME.png to the folder of --out and prints its path.
void deliver_picture(const Command& command, const Image& image, const std::string& name);

// Writes the measured numbers to the file of --json, where one is given.
void deliver_numbers(const Command& command, const nlohmann::ordered_json& numbers);

// A name for the pictures of a scene: `sphereflake:3` becomes sphereflake_3, a path its stem.
std::string picture_name(const Command& command);

} // namespace raysteps
