#pragma once

#include "gpu/context.h"
#include "image/image.h"
#include "scene/scene.h"

#include <filesystem>
#include <functional>

namespace raysteps {

// Renders the picture that a camera sees, so many pixels wide and high.
using RenderPicture = std::function<Image(const Camera& camera, int width, int height)>;

// Shows the picture in the window until it is closed, rendered anew as the camera moves: coarse
// while it does, in full when it rests. The mouse turns, moves and zooms like VTK's trackball
// (mouse.h), and H shows the keys. S writes the picture, in the window's full size, to
// SCREENSHOT-1.png or the next number that is free, and prints the path; C prints the camera.
// Throws MachineError where the window cannot be drawn to, InputError where a picture cannot be
// saved, and what the renderer throws: the person's view ends with it.
void show_in_window(WindowContext& context, const Camera& start,
                    const std::filesystem::path& screenshot, const RenderPicture& render);

} // namespace raysteps
