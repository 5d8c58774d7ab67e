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

} // namespace raysteps
