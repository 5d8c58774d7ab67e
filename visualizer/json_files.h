#pragma once

#include "stage.h"

#include <filesystem>
#include <string>

namespace raysteps::view {

// A state as JSON, and back: the same state, bit for bit.
std::string state_text(const State& state);

// A field that the text does not name is that of State{}. Throws InputError with the file's name
// and the field where the text is not a state.
State parse_state(const std::string& text, const std::string& name);

State read_state(const std::filesystem::path& path);
void save_state(const std::filesystem::path& path, const State& state);

// Writes the model, and the walk of the state's ray through the stage's first structure, for the
// figures of the book: a JSON object with
// points, triangles   the model: three numbers per point, three indices of points per triangle
// boxes               of all parts of the structure that list a triangle: lower and upper corner
// ray                 origin and end, three numbers each
// steps               each with its sentence, outcome, box (lower and upper corner, or null) and
//                     the numbers of the triangles that it tests and hits
// ending              why the walk ended
// Lengths are those of the scene, to six digits. Throws InputError where the state has no ray, or
// the file cannot be written.
void write_walk(const std::filesystem::path& path, const Stage& stage, const State& state);

} // namespace raysteps::view
