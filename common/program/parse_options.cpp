#include "program/parse_options.h"

#include "basics/error.h"

namespace raysteps {

ContextKind parse_context(const std::string& text) {
    if (text == "auto") {
        return ContextKind::automatic;
    }
    if (text == "osmesa") {
        return ContextKind::osmesa;
    }
    if (text == "egl") {
        return ContextKind::egl;
    }
    if (text == "window") {
        return ContextKind::window;
    }
    throw InputError("--context " + text +
                     ": there is no such context. Take one of auto, osmesa, egl, window.");
}

} // namespace raysteps
