#pragma once

#include "visualizer/stage.h"
#include "drawing.h"

#include <filesystem>

namespace raysteps::view {

// Writes what the drawing shows of its first pane, in the form that the ending names:
// .vtp   the cells, with number, depth, triangles, area and cost of each (ParaView)
// .vtm   the same, the model, the rays and the triangles tested, as blocks (ParaView)
// .gltf  the picture in space
// .vtkjs the same for VTK's viewers on web pages
// .json  the model and each step of the walk, for the figures of the book (walk_file.h)
// Throws InputError where there is no such form, or the file cannot be written.
void export_drawing(const std::filesystem::path& path, const Stage& stage, const State& state,
                    const Drawing& drawing, vtkRenderWindow& window);

} // namespace raysteps::view
