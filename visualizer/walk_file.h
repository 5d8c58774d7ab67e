#pragma once

#include "stage.h"

#include <filesystem>

namespace raysteps::view {

// Writes the model and the walk of the state's ray through the stage's first structure, for the
// figures of the book: a JSON object with
// points, triangles   the model: three numbers a point, three places of points a triangle
// ray                 origin and end, three numbers each
// steps               each with its sentence, outcome, box (lower and upper corner, or null) and
//                     the numbers of the triangles that it tests and hits
// ending              why the walk ended
// Lengths are those of the scene, to six digits. Throws InputError where the state has no ray, or
// the file cannot be written.
void write_walk(const std::filesystem::path& path, const Stage& stage, const State& state);

} // namespace raysteps::view
