#pragma once

#include <glm/vec3.hpp>

namespace raysteps {

// A point that shines equally in all directions, and equally strong at every distance, as in the
// paper: a surface shows (N.L) * colour of the surface * colour of the light.
struct Light {
    glm::vec3 position{0.0f};
    glm::vec3 color{1.0f};
};

} // namespace raysteps
