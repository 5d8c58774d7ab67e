#pragma once

#include "gpu/context.h"
#include "image/image.h"
#include "scene/camera.h"

#include <filesystem>
#include <functional>

namespace raysteps {

// Renders the picture that a camera sees, as large as asked.
using RenderPicture = std::function<Image(const Camera& camera, int width, int height)>;

// Shows the picture in the window until it is closed. The mouse orbits, pans and zooms like VTK's
// trackball; while the camera moves the picture is coarse, and it is rendered in full when it
// rests. The window resizes; S saves what it shows as SCREENSHOT-1.png, -2.png, ...; H shows the keys.
void show_in_window(WindowContext& context, const Camera& start,
                    const std::filesystem::path& screenshot, const RenderPicture& render);

} // namespace raysteps
