#pragma once

#include "trial.h"

namespace raysteps {

// All hard cases and checks, by sections: P, T, B, G, K, V, D, S, E, F, L.
const std::vector<Trial>& all_trials();

// The trial of that name; capitals do not matter. Throws InputError that lists the names where
// there is none.
const Trial& find_trial(const std::string& name);

// The shared edges and corners of a closed mesh, T1 and T2: what is watertight must be so for as
// many rays as one has time for, by the watertight test and every structure.
std::vector<Trial> leak_trials();

// Traces the case's rays by every structure with the watertight test, and where the case is about
// them, by every triangle test in the loop over every triangle; as C++ and on the GPU, as the tools
// say. A row for each. Structures are promised to find the bits of the loop; the watertight test,
// what the case says. Everything else is reported.
std::vector<TrialRow> run_hard_case(const HardCase& hard_case, const TrialTools& tools);

// Hard cases that are no mesh and rays, each list in the file of its name.
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

// a * b + c, in a file of its own, so that the compiler cannot see the numbers.
float multiply_add(float a, float b, float c);
double multiply_add(double a, double b, double c);

} // namespace raysteps
