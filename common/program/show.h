#pragma once

#include "image/image.h"
#include "program/options.h"

#include <functional>

namespace raysteps {

// Renders the picture that a camera sees, so many pixels wide and high.
using RenderPicture = std::function<Image(const Camera& camera, int width, int height)>;

// With --window: shows the picture in the window, rendering it anew as the camera moves, until the
// window is closed. Else renders it once, and writes NAME.png (sRGB) and NAME.pfm (linear floats)
// to the folder of --out.
void show_or_write(const PictureOptions& picture, Context& context, const Camera& camera,
                   const std::string& name, const RenderPicture& render);

// Shows the picture in the window until it is closed, rendered anew as the camera moves: coarse
// while it does, in full when it rests. The mouse turns, moves and zooms like VTK's trackball
// (window/trackball.h), and H shows the keys. S writes the picture, in the window's full size, to
// SCREENSHOT-1.png or the next number that is free, and prints the path; C prints the camera.
// Throws MachineError where the window cannot be drawn to, InputError where a picture cannot be
// saved, and what the renderer throws: the person's view ends with it.
void show_in_window(WindowContext& context, const Camera& start,
                    const std::filesystem::path& screenshot, const RenderPicture& render);

} // namespace raysteps
