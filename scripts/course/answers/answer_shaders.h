#pragma once

#include "answer.h"

namespace raysteps {

// Answers by the shaders as find_shader finds them. A context must be current.
// Throws InputError where a name of the question is none, MachineError where a shader does not
// compile.
Answer answer_by_shaders(const CourseQuestion& question);

} // namespace raysteps
