#pragma once

#include <string>

namespace raysteps {

// Whether Embree takes part, and in which of its modes.
enum class EmbreePart { none, fast, robust };

// off, fast or robust; auto is robust where this program was built with Embree, else off. Throws
// InputError for another word, and MachineError where Embree is asked for and missing.
EmbreePart parse_embree(const std::string& text);

} // namespace raysteps
