#pragma once

#include <string>

namespace raysteps {

// Throws MachineError if OpenGL has reported an error: `doing` ends the sentence
// "OpenGL ran out of memory while ...".
void check_gl(const std::string& doing);

// Forgets errors of calls whose failure was expected.
void clear_gl_errors();

} // namespace raysteps
