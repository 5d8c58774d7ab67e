#pragma once

#include "structure/structure.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// The planes of a grid as the kernels compute them, in C++.
template <class Real>
struct GridPlane {
    using real = Real;

#define precise
    static
#include "structure/grid/grid_plane.glsl"
#undef precise
};

// The plane between the cells i - 1 and i along one axis, the same bits as on a GPU.
inline float grid_plane(float lower, float cell_size, int i) {
    return GridPlane<float>::grid_plane(lower, cell_size, i);
}

// How fine a grid is to be.
struct GridOptions {
    double density = 4.0;                   // cells a triangle
    int resolution = 0;                     // cells along the longest side; 0: by the density
    double reach = 0.0;                     // see padding.h; usual_reach at least
    std::int64_t memory_limit = 4LL << 30U; // in bytes, for cells and references
    std::int64_t most_texels = std::numeric_limits<std::int32_t>::max(); // of starts, references
    unsigned threads = 0; // 0: as many as the machine has cores
    // Called with what the builder is about to take, in words, before it is taken.
    std::function<void(const std::string&)> say = [](const std::string&) {};
    std::function<void(const std::string&)> warn = [](const std::string&) {}; // as of BuildRequest
};

// Boxes of equal size: cell (x, y, z) lies between the planes x and x + 1, y and y + 1, z and z + 1
// (structure/grid/grid.h). Its number is x + cells.x * (y + cells.y * z). All triangles, padded,
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

// A uniform grid. The references [starts[cell], starts[cell + 1]) are those of the cell: all
// triangles that overlap it when it is grown by the padding, in ascending order.
struct Grid {
    GridShape shape;
    std::vector<std::int32_t> starts{0, 0};
    std::vector<std::int32_t> references;
};

// A reference has the triangle in its low 26 bits, and one bit a face of the cell, which says that
// the neighbour across that face lists the triangle as well. The face 2 * axis is the lower one of
// the axis, 2 * axis + 1 the upper one.
inline constexpr int triangle_bits = 26;
inline constexpr std::int32_t triangle_mask = (1 << triangle_bits) - 1;

inline std::int32_t triangle_of(std::int32_t reference) {
    return reference & triangle_mask;
}

inline bool is_in_neighbour(std::int32_t reference, int face) {
    return ((static_cast<std::uint32_t>(reference) >> (triangle_bits + face)) & 1U) != 0;
}

// As structure/grid/grid_plane.glsl has it.
PackedStructure pack(Grid grid);

} // namespace raysteps
