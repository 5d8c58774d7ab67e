#pragma once

#include <glm/vec3.hpp>

namespace raysteps {

// What a ray sees that leaves the scene, by its direction: the horizon where it runs level, the
// zenith straight up, the ground straight down, and mixtures between. Linear RGB.
struct Sky {
    glm::vec3 zenith{0.0f};
    glm::vec3 horizon{0.0f};
    glm::vec3 ground{0.0f};
};

} // namespace raysteps
