#pragma once

#include "recorded_walk.h"

#include <cstddef>
#include <string>
#include <vector>

namespace raysteps {

// A line of a shader: structure/grid/grid.glsl:66.
struct ShaderLine {
    std::string file;
    int number = 0;       // from 1
    std::string text;     // without the spaces before it
    std::string exercise; // 4.4, where the line is for a student to write
};

// The line that decides what became of a step, in the file of the walk or in one that it includes.
// Of a walk that spells it in words of its own, the line that calls observe_visit.
ShaderLine deciding_line(const RecordedWalk& walk, std::size_t step);

// The line with one of the words in the file shaders/structure/**/NAME.glsl or in one that it
// includes: the first words that stand there. Throws MachineError where none do, or where they
// stand twice in a file.
ShaderLine find_line(const std::string& structure, const std::vector<std::string>& words);

} // namespace raysteps
