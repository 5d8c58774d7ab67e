#pragma once

#include "image/image.h"

namespace raysteps {

// What mouse and keys do, as a picture to be laid over another one.
Image help_picture();

} // namespace raysteps
