#pragma once

#include "scene/mesh.h"

#include <glm/vec3.hpp>

#include <vector>

namespace raysteps {

// A cross-section of a tube: a circle around center, through the tips of the unit vectors right and
// up, which are perpendicular to each other and to the tube's direction right x up.
struct TubeSection {
    glm::dvec3 center{0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
};

// A closed tube that runs through the sections and back to the first, with `sides` quadrilaterals
// around: 2 * sections.size() * sides triangles with smooth normals.
Mesh closed_tube(const std::vector<TubeSection>& sections, double radius, int sides);

} // namespace raysteps
