#pragma once

#include "basics/box.h"

#include <glm/vec3.hpp>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>
#include <utility>

namespace raysteps::view {

using Shape = vtkSmartPointer<vtkPolyData>;

// The 12 edges of each box, with one value per box or none at all.
Shape box_edges(std::span<const Box> boxes, std::span<const double> values = {});

// The same edges, dashed.
Shape dashed_box_edges(std::span<const Box> boxes);

// The 6 faces of each box.
Shape box_faces(std::span<const Box> boxes, std::span<const double> values = {});

// A rectangle in space.
struct Rectangle {
    glm::vec3 corner;
    glm::vec3 side;
    glm::vec3 other_side;
};

Shape rectangles(std::span<const Rectangle> planes, std::span<const double> values = {});

// Triangles, three corners each.
Shape triangles(std::span<const glm::vec3> corners);

// One line per pair of points.
Shape line_segments(std::span<const std::pair<glm::vec3, glm::vec3>> segments);

} // namespace raysteps::view
