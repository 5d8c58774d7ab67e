#pragma once

#include "recorded_walk.h"

#include <cstddef>
#include <string>
#include <vector>

namespace raysteps {

// A line of a shader: structure/grid/grid.glsl:66.
struct ShaderLine {
    std::string file;
    int number = 0;   // from 1
    std::string text; // without the spaces before it
};

// Words of a line that stand once in its file.
struct LineMarker {
    std::string file;
    std::string words;
};

// The line that decides what became of a step. It is looked for in the shader folder. Throws
// MachineError where its words stand there no more, or twice.
ShaderLine deciding_line(const RecordedWalk& walk, std::size_t step);

ShaderLine find_line(const LineMarker& marker);

// All that deciding_line looks for.
std::vector<LineMarker> all_markers();

} // namespace raysteps
