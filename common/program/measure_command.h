#pragma once

#include "program/command.h"
#include "measure/measure_structures.h"

namespace raysteps {

// --measure: what the structures named cost on the scene, as a table, and as the file of --json.
void measure_and_report(const Command& command, const Scene& scene,
                        const std::vector<std::string>& structures);

} // namespace raysteps
