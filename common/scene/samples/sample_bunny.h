#pragma once

#include "scene/scene.h"

namespace raysteps {

// The Stanford bunny (Turk and Levoy, 1994) from Debian's package glmark2-data. The camera and the
// lights are left to be placed. Throws InputError where the package is not installed.
Scene sample_bunny();

} // namespace raysteps
