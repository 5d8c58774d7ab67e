#pragma once

#include "image/image.h"

#include <vtkRenderWindow.h>

#include <filesystem>

namespace raysteps::view {

// Renders the window, and what it shows then.
Image picture_of(vtkRenderWindow& window);

// The same as a PNG file. Throws InputError where it cannot be written.
void write_screenshot(vtkRenderWindow& window, const std::filesystem::path& path);

} // namespace raysteps::view
