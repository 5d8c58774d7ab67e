#pragma once

#include "geometry/layout.h"

#include <string>
#include <vector>

namespace raysteps {

// Rays of one kind.
struct RayFamily {
    std::string name;
    std::vector<Ray> rays;
};

} // namespace raysteps
