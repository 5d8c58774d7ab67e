#include "structure_cells.h"

#include "mirror/walks.h"
#include "structure/bvh/bvh_split.h"
#include "structure/grid/grid.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>

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

// How many triangles a leaf has, from its first one on.
template <class Mirror>
int triangles_from(Mirror& mirror, int first) {
    int count = 1;
    while (!mirror.bvh_triangle(first + count - 1).last) {
        ++count;
    }
    return count;
}

// Each node in the order of octant 0, where the planes that come first are the lower ones: a node,
// its near branch, its far one. A branch ends where its skip leads.
template <class Mirror>
StructureCells tree_cells_of(const PackedStructure& packed) {
    Mirror mirror{};
    mirror.read(packed);
    StructureCells tree;
    tree.kind = CellKind::bvh;
    tree.cells.resize(static_cast<std::size_t>(mirror.bvh_node_count));
    std::vector<int> open; // the branches that a node is in
    for (int i = 0; i < mirror.bvh_node_count; ++i) {
        while (!open.empty() && mirror.bvh_node(open.back()).skip == i) {
            open.pop_back();
        }
        const auto node = mirror.bvh_node(i);
        Cell& cell = tree.cells[static_cast<std::size_t>(i)];
        cell.box = {node.first_planes, node.last_planes};
        cell.parent = open.empty() ? no_cell : open.back();
        cell.leaf = mirror.is_bvh_leaf(node);
        if (!cell.leaf) {
            open.push_back(i);
            continue;
        }
        cell.first = node.link;
        cell.triangles = triangles_from(mirror, node.link);
    }
    return tree;
}

// The nodes of four children, then the leaves. A node's own box stands in its parent; that of the
// root holds those of its children.
StructureCells wide_cells_of(const PackedStructure& packed) {
    StructureCells tree;
    tree.kind = CellKind::bvh;
    tree.cells.resize(static_cast<std::size_t>(packed.numbers.at("bvh_node_count")));
    for (const Bvh4Child& child : bvh4_children_of(packed)) {
        if (child.leaf) {
            tree.cells.emplace_back();
        }
        Cell& cell = tree.cells[static_cast<std::size_t>(child.cell)];
        cell.box = child.box;
        cell.parent = child.parent;
        cell.leaf = child.leaf;
        cell.triangles = child.triangles;
        cell.first = child.first;
        if (child.parent == 0) {
            Box& root = tree.cells[0].box;
            root = merge(root, child.box);
            tree.cells[0].leaf = false;
        }
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
    if (packed.integer_vectors.contains("bvh_nodes")) {
        return tree_cells_of<mirror::walks::bvh_skip<float>>(packed);
    }
    if (packed.integer_vectors.contains("bvh4_nodes")) {
        return wide_cells_of(packed);
    }
    if (packed.integer_vectors.contains("half_nodes")) {
        return tree_cells_of<mirror::walks::half_bvh<float>>(packed);
    }
    return {};
}

Box whole_of(const StructureCells& structure) {
    Box whole;
    for (const Cell& cell : structure.cells) {
        whole = merge(merge(whole, cell.box.lower), cell.box.upper);
    }
    return whole;
}

} // namespace

std::vector<Bvh4Child> bvh4_children_of(const PackedStructure& packed) {
    mirror::walks::bvh4<float> mirror{};
    mirror.read(packed);
    std::vector<Bvh4Child> children;
    int cells = mirror.bvh_node_count;
    for (int node = 0; node < mirror.bvh_node_count; ++node) {
        const glm::ivec4 links = mirror.bvh4_links(8 * node);
        for (int i = 0; i < 4 && links[i] != mirror.no_bvh4_place; ++i) {
            Bvh4Child child;
            child.parent = node;
            child.link = links[i];
            child.leaf = mirror.is_bvh4_leaf(links[i]);
            child.cell = child.leaf ? cells++ : links[i] / 8;
            for (int axis = 0; axis < 3; ++axis) {
                child.box.lower[axis] = mirror.bvh4_planes(8 * node + 2 * axis)[i];
                child.box.upper[axis] = mirror.bvh4_planes(8 * node + 2 * axis + 1)[i];
            }
            if (child.leaf) {
                child.first = mirror.bvh4_first_triangle(child.link);
                child.triangles = triangles_from(mirror, child.first);
            }
            children.push_back(child);
        }
    }
    return children;
}

namespace {

// The cells are given so that a parent comes before its children.
void add_up(StructureCells& structure, std::span<const std::size_t> order, const CellCosts& costs) {
    std::vector<Cell>& cells = structure.cells;
    const double whole = surface_area(whole_of(structure));
    for (const std::size_t number : order) {
        Cell& cell = cells[number];
        if (cell.parent != no_cell) {
            cell.depth = cells[static_cast<std::size_t>(cell.parent)].depth + 1;
        }
        structure.deepest = std::max(structure.deepest, cell.depth);
        const bool has_step = !cell.leaf || structure.kind == CellKind::grid;
        const double cost = (has_step ? costs.traversal : 0.0) +
                            (cell.leaf ? costs.intersection * cell.triangles : 0.0);
        cell.cost = whole > 0.0 ? cost * surface_area(cell.box) / whole : 0.0;
    }
    for (std::size_t i = order.size(); i-- > 0;) {
        const Cell& cell = cells[order[i]];
        if (cell.parent != no_cell) {
            cells[static_cast<std::size_t>(cell.parent)].triangles += cell.triangles;
        }
    }
}

} // namespace

StructureCells cells_of(const PackedStructure& packed, const CellCosts& costs) {
    StructureCells structure = bare_cells_of(packed);
    std::vector<std::size_t> order(structure.cells.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    add_up(structure, order, costs);
    return structure;
}

StructureCells cells_of(const BoxTree& tree, const CellCosts& costs) {
    StructureCells structure;
    structure.kind = CellKind::bvh;
    structure.cells.resize(tree.nodes.size());
    std::vector<std::size_t> order; // of those that are reached
    std::vector<char> reached(tree.nodes.size(), 0);
    if (!tree.nodes.empty()) {
        order.push_back(0);
        reached[0] = 1;
    }
    for (std::size_t next = 0; next < order.size(); ++next) {
        const std::size_t node = order[next];
        structure.cells[node].leaf = is_leaf(tree, node);
        for (const std::int32_t child : children_of(tree, node)) {
            const auto place = static_cast<std::size_t>(child);
            if (child >= 0 && place < tree.nodes.size() && reached[place] == 0) {
                reached[place] = 1;
                structure.cells[place].parent = static_cast<int>(node);
                order.push_back(place);
            }
        }
        if (structure.cells[node].leaf) {
            structure.cells[node].triangles =
                std::clamp(tree.nodes[node].count, 0, static_cast<int>(tree.order.size()));
        }
    }
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        structure.cells[i].box = tree.nodes[i].box;
    }
    add_up(structure, order, costs);
    return structure;
}

BoxTree box_tree_of(const StructureCells& cells, const PackedStructure& packed) {
    BoxTree tree;
    tree.width = packed.integer_vectors.contains("bvh4_nodes") ? 4 : 2;
    const auto width = static_cast<std::size_t>(tree.width);
    tree.children.assign(width * cells.cells.size(), no_child);
    for (std::size_t i = 0; i < cells.cells.size(); ++i) {
        const Cell& cell = cells.cells[i];
        tree.nodes.push_back({cell.box, cell.first, cell.leaf ? cell.triangles : 0});
        if (cell.parent != no_cell) {
            std::size_t place = width * static_cast<std::size_t>(cell.parent);
            while (tree.children[place] != no_child) {
                ++place;
            }
            tree.children[place] = static_cast<std::int32_t>(i);
        }
    }
    const std::vector<glm::ivec4>& corners = packed.integer_vectors.at("bvh_triangles");
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        tree.order.push_back(corners[i].w);
    }
    return tree;
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
