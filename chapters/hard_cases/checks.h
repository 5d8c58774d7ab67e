#pragma once

#include "trial.h"

// Hard cases that are no mesh and rays, each list in its file.
namespace raysteps {

std::vector<Trial> paper_checks();    // P: what compilers refuse, and lamps
std::vector<Trial> triangle_checks(); // T: contraction, signs of zero, ranges, errors of t
std::vector<Trial> box_checks();      // B: the box test
std::vector<Trial> grid_checks();     // G: the length of a walk
std::vector<Trial> tree_checks();     // V: builders
std::vector<Trial> surface_checks();  // S: rays that leave a surface
std::vector<Trial> effect_checks();   // E: mirrors
std::vector<Trial> glass_checks();    // E: glass
std::vector<Trial> file_checks();     // F: the loader
std::vector<Trial> platform_checks(); // L: what OpenGL does without saying so

} // namespace raysteps
