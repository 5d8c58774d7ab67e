#include "structure_cells.h"

#include "structure/grid/grid.h"
#include "structure/bvh/bvh_split.h"

#include <algorithm>
#include <bit>

namespace raysteps {

namespace {

StructureCells grid_cells_of(const PackedStructure& packed) {
    StructureCells grid;
    grid.kind = CellKind::grid;
    grid.grid_cells = packed.counts.at("grid_cells");
    const glm::vec3 lower = packed.points.at("grid_lower");
    const glm::vec3 size = packed.points.at("grid_cell_size");
    const std::vector<std::int32_t>& starts = packed.integers.at("grid_starts");
    grid.cells.resize(starts.size() - 1);
    std::size_t number = 0;
    for (int z = 0; z < grid.grid_cells.z; ++z) {
        for (int y = 0; y < grid.grid_cells.y; ++y) {
            for (int x = 0; x < grid.grid_cells.x; ++x, ++number) {
                const glm::ivec3 place(x, y, z);
                Cell& cell = grid.cells[number];
                for (int axis = 0; axis < 3; ++axis) {
                    cell.box.lower[axis] = grid_plane(lower[axis], size[axis], place[axis]);
                    cell.box.upper[axis] = grid_plane(lower[axis], size[axis], place[axis] + 1);
                }
                cell.triangles = starts[number + 1] - starts[number];
            }
        }
    }
    return grid;
}

StructureCells kd_cells_of(const PackedStructure& packed) {
    StructureCells tree;
    tree.kind = CellKind::kd_tree;
    const std::vector<glm::ivec4>& nodes = packed.integer_vectors.at("kd_nodes");
    const std::vector<glm::vec4>& boxes = packed.vectors.at("kd_boxes");
    tree.cells.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        Cell& cell = tree.cells[i];
        const glm::ivec4& node = nodes[i];
        cell.box = {glm::vec3(boxes[2 * i]), glm::vec3(boxes[2 * i + 1])};
        cell.parent = node.w;
        cell.leaf = (node.x & 3) == 3;
        if (cell.leaf) {
            cell.triangles = node.z - node.y;
        } else {
            cell.axis = node.x & 3;
            cell.split = std::bit_cast<float>(node.y);
        }
    }
    return tree;
}

// The triangles of a leaf go on until one says that it is the last.
int count_in_leaf(const std::vector<glm::ivec4>& triangles, int first) {
    int count = 1;
    while (triangles[3 * static_cast<std::size_t>(first + count - 1) + 1].w == 0) {
        ++count;
    }
    return count;
}

glm::vec3 point_of(const glm::ivec4& texel) {
    return {std::bit_cast<float>(texel.x), std::bit_cast<float>(texel.y),
            std::bit_cast<float>(texel.z)};
}

// In octant 0 the planes that come first are the lower ones.
StructureCells bvh_cells_of(const PackedStructure& packed) {
    StructureCells tree;
    tree.kind = CellKind::bvh;
    const std::vector<glm::ivec4>& nodes = packed.integer_vectors.at("bvh_nodes");
    const std::vector<std::int32_t>& parents = packed.integers.at("bvh_parents");
    tree.cells.resize(parents.size());
    for (std::size_t i = 0; i < parents.size(); ++i) {
        Cell& cell = tree.cells[i];
        cell.box = {point_of(nodes[2 * i]), point_of(nodes[2 * i + 1])};
        cell.parent = parents[i];
        const int link = nodes[2 * i + 1].w;
        cell.leaf = link >= 0;
        cell.triangles =
            cell.leaf ? count_in_leaf(packed.integer_vectors.at("bvh_triangles"), link) : 0;
    }
    return tree;
}

StructureCells bare_cells_of(const PackedStructure& packed) {
    if (packed.counts.contains("grid_cells")) {
        return grid_cells_of(packed);
    }
    if (packed.integer_vectors.contains("kd_nodes")) {
        return kd_cells_of(packed);
    }
    return packed.integer_vectors.contains("bvh_nodes") ? bvh_cells_of(packed) : StructureCells{};
}

Box whole_of(const StructureCells& structure) {
    Box whole;
    for (const Cell& cell : structure.cells) {
        whole = merge(merge(whole, cell.box.lower), cell.box.upper);
    }
    return whole;
}

} // namespace

StructureCells cells_of(const PackedStructure& packed, const CellCosts& costs) {
    StructureCells structure = bare_cells_of(packed);
    std::vector<Cell>& cells = structure.cells;
    const double whole = surface_area(whole_of(structure));
    for (Cell& cell : cells) {
        if (cell.parent != no_cell) {
            cell.depth = cells[static_cast<std::size_t>(cell.parent)].depth + 1;
        }
        structure.deepest = std::max(structure.deepest, cell.depth);
        const bool has_step = !cell.leaf || structure.kind == CellKind::grid;
        const double cost = (has_step ? costs.traversal : 0.0) +
                            (cell.leaf ? costs.intersection * cell.triangles : 0.0);
        cell.cost = whole > 0.0 ? cost * surface_area(cell.box) / whole : 0.0;
    }
    for (std::size_t i = cells.size(); i-- > 0;) {
        if (cells[i].parent != no_cell) {
            cells[static_cast<std::size_t>(cells[i].parent)].triangles += cells[i].triangles;
        }
    }
    return structure;
}

std::string cell_name(const StructureCells& structure, int cell) {
    if (structure.kind == CellKind::grid) {
        const int row = cell / structure.grid_cells.x;
        return "cell (" + std::to_string(cell % structure.grid_cells.x) + "," +
               std::to_string(row % structure.grid_cells.y) + "," +
               std::to_string(row / structure.grid_cells.y) + ")";
    }
    const bool leaf = structure.cells[static_cast<std::size_t>(cell)].leaf;
    return (leaf ? "leaf " : "node ") + std::to_string(cell);
}

bool same_cells(const StructureCells& a, const StructureCells& b) {
    return a.kind == b.kind && std::equal(a.cells.begin(), a.cells.end(), b.cells.begin(),
                                          b.cells.end(), [](const Cell& first, const Cell& second) {
                                              return first.box.lower == second.box.lower &&
                                                     first.box.upper == second.box.upper &&
                                                     first.leaf == second.leaf;
                                          });
}

} // namespace raysteps
