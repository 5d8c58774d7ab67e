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

// A tube along the torus knot that winds seven times around the torus' axis and sixteen times
// around its ring: 1,024 * size * size triangles. It fits in a box of about 4.1 * 4.1 * 1.6 around
// the origin.
Mesh torus_knot(int size);

// Heights at the crossings of a square grid, row by row: (cells + 1) * (cells + 1) numbers.
struct HeightField {
    int cells = 1;
    std::vector<float> heights;
};

float height_at(const HeightField& field, int column, int row);

// A random mountain of 2^depth * 2^depth cells with its corners at 0: midpoints are moved by random
// amounts that halve from level to level (Fournier, Fussell and Carpenter, "Computer rendering of
// stochastic models", 1982). The same seed gives the same bits.
HeightField random_mountain(int depth, int seed);

} // namespace raysteps
