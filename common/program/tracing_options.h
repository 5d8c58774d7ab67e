#pragma once

#include "program/command.h"
#include "basics/ray.h"
#include "gpu/shaders.h"
#include "structure/structure.h"

#include <span>

namespace raysteps {

// --triangle --structure --rays --hits, of the chapters that trace, and the options of all
// builders.
void add_tracing_options(CLI::App& app, Command& command);

// The parts that --triangle and --structure ask for. Throws InputError.
Parts trace_parts(const Command& command);

// Throws InputError where an option was given that no builder of these structures has: it would be
// passed over in silence.
void check_build_values(const Command& command, std::span<const std::string> structures);

// The structure of --structure over the scene, for rays from the scene's camera (and from wherever
// a person in a window may go), or for the rays given. Prints the facts of it.
BuiltStructure build_structure(const Command& command, const Scene& scene);
BuiltStructure build_structure(const Command& command, const Scene& scene,
                               std::span<const Ray> rays);

} // namespace raysteps
