#pragma once

#include "drawing.h"
#include "visualizer/stage.h"

#include <filesystem>

namespace raysteps::view {

// Writes what the drawing shows of its first pane, in the format of the file's extension:
// .vtp   the cells, with number, depth, triangles, area and cost of each (ParaView)
// .vtm   the cells, the model, the rays and the triangles tested, as blocks (ParaView)
// .gltf  the picture in space
// .vtkjs the same for VTK's viewers on web pages
// .json  the model and each step of the walk, for the figures of the book (walk.schema.json)
// Throws InputError if there is no such format, or the file cannot be written.
void export_drawing(const std::filesystem::path& path, const Stage& stage, const State& state,
                    const Drawing& drawing, vtkRenderWindow& window);

} // namespace raysteps::view
