#pragma once

#include "answer.h"
#include "gpu/program.h"

#include <optional>
#include <string>

namespace raysteps {

// The program of the last checkpoint. Those of a whole walk differ in uniforms only, and to compile
// takes longer than to ask. Must not outlive the context.
struct KeptProgram {
    std::string text;
    std::optional<Program> program;
};

// Answers by the shaders as find_shader finds them. A context must be current.
// Throws InputError where a name of the question is none, MachineError where a shader does not
// compile.
Answer answer_by_shaders(const CourseQuestion& question, KeptProgram& kept);

} // namespace raysteps
