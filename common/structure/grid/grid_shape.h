#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace raysteps {

// How fine a grid is to be.
struct GridOptions {
    double density = 4.0;                   // cells a triangle
    int resolution = 0;                     // cells along the longest side; 0: by the density
    double reach = 0.0;                     // see padding.h; usual_reach at least
    std::int64_t memory_limit = 4LL << 30U; // in bytes, for cells and references
    unsigned threads = 0;                   // 0: as many as the machine has cores
    // Called with what the builder is about to take, in words, before it is taken.
    std::function<void(const std::string&)> say = [](const std::string&) {};
};

// Boxes of equal size: cell (x, y, z) lies between the planes x and x + 1, y and y + 1, z and z + 1
// (geometry/grid_plane.h). Its number is x + cells.x * (y + cells.y * z). All triangles, padded,
// lie between the first and the last planes.
struct GridShape {
    glm::vec3 lower{0.0f};
    glm::vec3 cell_size{1.0f};
    glm::ivec3 cells{1};
    double padding = 0.0; // how far a triangle reaches beyond its corners (padding.h)
};

inline std::int64_t cell_count(const GridShape& shape) {
    return std::int64_t{shape.cells.x} * shape.cells.y * shape.cells.z;
}

// The shape for these triangles, three corners each, all finite: density * triangles cells, about
// as long as wide as high. A cell is never thinner than eight paddings: where the rays come from
// far away, the grid is coarse. Source of the rule: Cleary, Wyvill, Birtwistle and Vatti,
// "Multiprocessor Ray Tracing", 1986; in this form: Wald, Ize, Kensler, Knoll and Parker, "Ray
// Tracing Animated Scenes using Coherent Grid Traversal", 2006.
GridShape shape_grid(std::span<const glm::vec3> corners, const GridOptions& options);

} // namespace raysteps
