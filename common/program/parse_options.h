#pragma once

#include "gpu/context.h"

#include <string>

namespace raysteps {

// auto, osmesa, egl or window. Throws InputError.
ContextKind parse_context(const std::string& text);

} // namespace raysteps
