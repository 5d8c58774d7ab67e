#pragma once

#include <glm/vec3.hpp>

namespace raysteps {

// A point that shines equally in all directions, and equally strong at every distance, as in the
// paper: a surface shows (N.L) * colour of the surface * colour of the light. With both edges it is
// a parallelogram around the position, and its colour is that of all its points together.
struct Light {
    glm::vec3 position{0.0f};
    glm::vec3 color{1.0f};
    glm::vec3 across{0.0f}; // the edges of the parallelogram; zero for a point
    glm::vec3 along{0.0f};
};

inline bool has_area(const Light& light) {
    return light.across != glm::vec3(0.0f) || light.along != glm::vec3(0.0f);
}

} // namespace raysteps
