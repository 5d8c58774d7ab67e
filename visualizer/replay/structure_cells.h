#pragma once

#include "basics/box.h"
#include "structure/bvh/box_tree.h"
#include "structure/structure.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace raysteps {

inline constexpr int no_cell = -1;
inline constexpr int no_axis = -1;

// A part of a structure as a box: the cell of a grid, or a node of a tree.
struct Cell {
    Box box;
    int parent = no_cell;
    int depth = 0;
    int triangles = 0; // listed in it; of an inner node, in all leaves below together
    int first = 0;     // of a leaf of a BVH: where its triangles begin in `bvh_triangles`
    bool leaf = true;
    int axis = no_axis; // of the plane at which a node of a kd-tree parts its box
    float split = 0.0f;
    double cost = 0.0; // what it adds to the expected cost of a ray through the whole
};

enum class CellKind { none, grid, kd_tree, bvh };

// All parts of a structure. A cell's place here is what walks call it; of a BVH it is the place in
// octant 0, and of one with four children a node the nodes come first, then the leaves. A parent
// stands before its children.
struct StructureCells {
    CellKind kind = CellKind::none;
    std::vector<Cell> cells;
    glm::ivec3 grid_cells{0}; // of a grid
    int deepest = 0;
};

// What a cell is expected to cost: a step, and a test for each triangle of a leaf.
struct CellCosts {
    double traversal = 1.0;
    double intersection = 1.5;
};

// The cells of a structure, from the very arrays that its walks read: of a structure that has none,
// no cell. A cell is met with the probability of its surface over that of the whole, and costs
// there what measure_bvh says. In time linear in the cells and references.
StructureCells cells_of(const PackedStructure& packed, const CellCosts& costs);

// The nodes of a tree from a file, through which a walk need not be able to go: a cell has its
// node's number, and the parent by which it is reached first.
StructureCells cells_of(const BoxTree& tree, const CellCosts& costs);

// The hierarchy that the walks of these cells, which are of a BVH, read; a node has its cell's
// number.
BoxTree box_tree_of(const StructureCells& cells, const PackedStructure& packed);

// A child of a node of four (shaders/structure/bvh/bvh4_nodes.glsl).
struct Bvh4Child {
    Box box;
    int parent = no_cell;
    int cell = no_cell;
    int link = 0;
    bool leaf = false;
    int triangles = 0; // of a leaf
    int first = 0;     // of them, as of a Cell
};

// All of them, node by node.
std::vector<Bvh4Child> bvh4_children_of(const PackedStructure& packed);

// `cell (3,0,5)`, `node 12` or `leaf 12`.
std::string cell_name(const StructureCells& structure, int cell);

// Whether both have the same boxes, so that a cell's place means the same in both.
bool same_cells(const StructureCells& a, const StructureCells& b);

} // namespace raysteps
