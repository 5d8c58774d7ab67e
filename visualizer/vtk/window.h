#pragma once

#include "image/image.h"

#include <glm/vec2.hpp>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace raysteps::view {

// Whether there is a display to open a window on. Without one, VTK would end the program.
bool has_display();

// A window of that size that needs no display: VTK draws into a framebuffer of an EGL context
// without a surface. One at a time per process. Throws MachineError where the machine has no such
// OpenGL.
vtkSmartPointer<vtkRenderWindow> make_headless_window(const glm::ivec2& size);

// Renders the window, and returns what it then shows.
Image picture_of(vtkRenderWindow& window);

// The same as a PNG file. Throws InputError where it cannot be written.
void write_screenshot(vtkRenderWindow& window, const std::filesystem::path& path);

} // namespace raysteps::view
