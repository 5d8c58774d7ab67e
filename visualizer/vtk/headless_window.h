#pragma once

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <glm/vec2.hpp>

namespace raysteps::view {

// A window of that size that no screen shows: VTK draws into a framebuffer of an EGL context
// without a surface, so it needs no display. One at a time in a process. Throws MachineError where
// the machine has no such OpenGL.
vtkSmartPointer<vtkRenderWindow> make_headless_window(const glm::ivec2& size);

} // namespace raysteps::view
