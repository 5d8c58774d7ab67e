#include "inspection.h"

#include "basics/error.h"
#include "basics/text.h"
#include "reference/embree/embree.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/check_bvh.h"
#include "structure/grid/check_grid.h"
#include "structure/kd_tree/check_kd_tree.h"
#include "structure/padding.h"

#include <fmt/core.h>

#include <algorithm>

namespace raysteps {

BoxTree embree_tree(std::span<const glm::vec3> corners, const BvhOptions& options) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        boxes.push_back(bounds_of(corners.subspan(i, 3)));
    }
    EmbreeBuilder builder(boxes, {.leaf_triangles = options.leaf_triangles,
                                  .traversal_cost = options.traversal_cost,
                                  .intersection_cost = options.intersection_cost});
    builder.prepare();
    builder.build();
    BoxTree tree;
    const EmbreeNodes read = builder.nodes();
    for (const EmbreeNode& node : read.nodes) {
        tree.nodes.push_back({node.box, node.first, node.count});
        tree.children.insert(tree.children.end(), node.children.begin(), node.children.end());
    }
    tree.order = read.triangles;
    return tree;
}

namespace {

// So many misplaced children are compared with each other: all pairs of them.
constexpr std::size_t most_misplaced = 2000;

bool encloses(const Box& outer, const Box& inner) {
    bool all = true;
    for (int axis = 0; axis < 3; ++axis) {
        all =
            all && outer.lower[axis] <= inner.lower[axis] && inner.upper[axis] <= outer.upper[axis];
    }
    return all;
}

// A child that its parent's box does not enclose.
struct Misplaced {
    std::size_t parent = 0;
    std::size_t child = 0;
};

std::vector<Misplaced> misplaced_children(const BoxTree& tree) {
    std::vector<Misplaced> misplaced;
    for (std::size_t i = 0; i < tree.nodes.size() && misplaced.size() < most_misplaced; ++i) {
        for (const std::int32_t child : children_of(tree, i)) {
            if (child >= 0 && static_cast<std::size_t>(child) < tree.nodes.size() &&
                !encloses(tree.nodes[i].box, tree.nodes[static_cast<std::size_t>(child)].box)) {
                misplaced.push_back({i, static_cast<std::size_t>(child)});
            }
        }
    }
    return misplaced;
}

// Two that fit in each other's place.
void guess_swaps(const BoxTree& tree, std::vector<std::string>& guesses) {
    const std::vector<Misplaced> misplaced = misplaced_children(tree);
    for (std::size_t i = 0; i < misplaced.size(); ++i) {
        for (std::size_t j = i + 1; j < misplaced.size(); ++j) {
            const Misplaced& one = misplaced[i];
            const Misplaced& other = misplaced[j];
            if (encloses(tree.nodes[one.parent].box, tree.nodes[other.child].box) &&
                encloses(tree.nodes[other.parent].box, tree.nodes[one.child].box)) {
                guesses.push_back(fmt::format(
                    "Two children are swapped: node {} has node {}, which fits under node {}, and "
                    "node {} has node {}, which fits under node {}.",
                    one.parent, one.child, other.parent, other.parent, other.child, one.parent));
                return;
            }
        }
    }
}

BoxTree renumbered(BoxTree tree, const std::function<std::int32_t(std::int32_t)>& number) {
    for (std::int32_t& triangle : tree.order) {
        triangle = number(triangle);
    }
    return tree;
}

std::size_t misfits_of(const TreeFindings& found) {
    return count_of(found.faults, fault_of_leaf_box) +
           count_of(found.faults, fault_of_lost_triangle);
}

// Numbers that count what the loader leaves out, or count from 1, put boxes around the wrong
// triangles: all is well once they are counted as the scene counts.
void guess_shift(const BoxTree& tree, const Scene& scene, const TreeFindings& found,
                 std::vector<std::string>& guesses) {
    const std::size_t misfits = misfits_of(found);
    if (misfits == 0) {
        return;
    }
    const auto misfits_by = [&](const std::function<std::int32_t(std::int32_t)>& number) {
        return misfits_of(find_faults(renumbered(tree, number), scene.corners, 0.0));
    };
    const std::vector<int>& out = scene.left_out;
    const auto without_left_out = [&](std::int32_t triangle) {
        const auto place = std::ranges::lower_bound(out, triangle);
        const bool is_out = place != out.end() && *place == triangle;
        return is_out ? far_out : triangle - static_cast<std::int32_t>(place - out.begin());
    };
    if (!out.empty() && 10 * misfits_by(without_left_out) < misfits) {
        guesses.push_back(fmt::format(
            "The triangle numbers are shifted by dropped faces: they count the {} that the loader "
            "leaves out, the first of which would be triangle {}. Leave those faces out before "
            "you build, or write the triangles into the file.",
            out.size(), out.front()));
        return;
    }
    if (10 * misfits_by([](std::int32_t triangle) { return triangle - 1; }) < misfits) {
        guesses.push_back("The triangle numbers are one too high: they count from 1. Count from "
                          "0.");
    }
}

void inspect_boxes(Inspection& inspection, const BoxTree& tree, const Scene& scene,
                   const BvhOptions& options, const std::function<void(double)>& progress) {
    const std::span<const glm::vec3> corners = scene.corners;
    const double padding = padding_for(usual_reach(bounds_of(corners), options.reach));
    const TreeFindings found = find_faults(tree, corners, padding);
    inspection.faults = found.faults;
    inspection.remarks = found.remarks;
    progress(0.2);
    if (count_of(found.faults, fault_of_child_box) > 0) {
        guess_swaps(tree, inspection.guesses);
    }
    guess_shift(tree, scene, found, inspection.guesses);
    progress(0.3);
    inspection.measured.push_back({"the file's", measure_box_tree(tree, options)});
    progress(0.4);
    const Bvh own = build_bvh(corners, options);
    inspection.measured.push_back({"Raysteps", measure_box_tree(box_tree_of(own), options)});
    progress(0.7);
    if (!embree_name().empty() && !corners.empty()) {
        inspection.measured.push_back(
            {embree_name(), measure_box_tree(embree_tree(corners, options), options)});
    }
}

void add_all(FaultList& faults, const std::string& kind, const std::vector<std::string>& found) {
    for (const std::string& sentence : found) {
        faults.add(kind, [&] { return sentence; });
    }
}

// Links and boxes were sound when it was read.
void inspect_kd_tree(Inspection& inspection, const KdTree& tree, const Scene& scene) {
    add_all(inspection.faults, "wrong list of a leaf",
            faults_of_references(tree, scene.corners.size() / 3));
    if (inspection.faults.kinds.empty()) {
        add_all(inspection.faults, "triangle not listed where it reaches",
                missing_references(tree, scene.corners));
    }
}

} // namespace

Inspection inspect(const AnyTree& tree, const Scene& scene, const BvhOptions& options,
                   const std::function<void(double)>& progress) {
    Inspection inspection;
    if (const auto* const boxes = std::get_if<BoxTree>(&tree)) {
        inspect_boxes(inspection, *boxes, scene, options, progress);
    } else if (const auto* const kd_tree = std::get_if<KdTree>(&tree)) {
        inspect_kd_tree(inspection, *kd_tree, scene);
    } else {
        add_all(inspection.faults, "wrong cell", check_grid(std::get<Grid>(tree), scene.corners));
    }
    progress(1.0);
    return inspection;
}

namespace {

std::string to_table(const FaultList& faults, std::size_t most_told) {
    std::string table;
    for (const FaultKind& kind : faults.kinds) {
        table += fmt::format("  {}: {}\n", kind.name, readable(static_cast<double>(kind.count)));
        const std::size_t told = std::min(kind.first.size(), most_told);
        for (std::size_t i = 0; i < told; ++i) {
            table += "    " + kind.first[i] + "\n";
        }
        if (kind.count > told) {
            table += "    ...\n";
        }
    }
    return table;
}

// 1, 2, 3, 4, 5 to 8, 9 to 16, ... triangles.
std::string histogram_of(const BoxTreeMeasures& measures) {
    std::map<std::size_t, std::size_t> leaves; // by the most triangles of a class
    for (const auto& [size, count] : measures.leaves_of_size) {
        std::size_t most = 4;
        while (most < size) {
            most *= 2;
        }
        leaves[size <= 4 ? size : most] += count;
    }
    std::string text;
    for (const auto& [most, count] : leaves) {
        const std::string name = most <= 4
                                     ? std::to_string(most)
                                     : std::to_string(most / 2 + 1) + " to " + std::to_string(most);
        text += (text.empty() ? "" : ", ") + name + ": " + readable(static_cast<double>(count));
    }
    return text;
}

Numbers numbers_of(const FaultList& faults) {
    Numbers kinds = empty_list();
    for (const FaultKind& kind : faults.kinds) {
        kinds.push_back({{"fault", kind.name}, {"count", kind.count}, {"first", kind.first}});
    }
    return kinds;
}

} // namespace

std::string to_table(const Inspection& inspection) {
    std::string table;
    if (!inspection.faults.kinds.empty()) {
        table += "\nFaults\n" + to_table(inspection.faults, 10);
    }
    for (const std::string& guess : inspection.guesses) {
        table += "  So it seems: " + guess + "\n";
    }
    if (!inspection.remarks.kinds.empty()) {
        table += "\nRemarks\n" + to_table(inspection.remarks, 3);
    }
    if (inspection.measured.empty()) {
        return table;
    }
    table += fmt::format("\n{:18}{:>11}{:>10}{:>12}{:>7}{:>10}{:>9}{:>9}{:>13}\n", "tree", "nodes",
                         "leaves", "references", "depth", "SAH cost", "overlap", "empty", "bytes");
    for (const MeasuredTree& tree : inspection.measured) {
        const BoxTreeMeasures& each = tree.measures;
        table +=
            fmt::format("{:18}{:>11}{:>10}{:>12}{:>7}{:>10}{:>9}{:>8.1f}%{:>13}\n", tree.name,
                        readable(static_cast<double>(each.tree.nodes)),
                        readable(static_cast<double>(each.tree.leaves)),
                        readable(static_cast<double>(each.tree.references)), each.tree.depth,
                        readable(each.tree.cost), readable(each.overlap), 100.0 * each.empty_space,
                        readable(static_cast<double>(each.tree.bytes)));
    }
    table += "\nLeaves by their number of triangles\n";
    for (const MeasuredTree& tree : inspection.measured) {
        table += fmt::format("  {:18}{}\n", tree.name, histogram_of(tree.measures));
    }
    return table;
}

Numbers numbers_of(const Inspection& inspection) {
    Numbers measured = empty_list();
    for (const MeasuredTree& tree : inspection.measured) {
        const BoxTreeMeasures& each = tree.measures;
        Numbers sizes = empty_list();
        for (const auto& [triangles, leaves] : each.leaves_of_size) {
            sizes.push_back({{"triangles", triangles}, {"leaves", leaves}});
        }
        measured.push_back({{"name", tree.name},
                            {"nodes", each.tree.nodes},
                            {"leaves", each.tree.leaves},
                            {"references", each.tree.references},
                            {"depth", each.tree.depth},
                            {"longest_leaf", each.tree.longest_leaf},
                            {"expected_cost", each.tree.cost},
                            {"overlap", each.overlap},
                            {"empty_space", each.empty_space},
                            {"tree_bytes", each.tree.bytes},
                            {"leaf_sizes", sizes}});
    }
    return {{"fault_kinds", numbers_of(inspection.faults)},
            {"remarks", numbers_of(inspection.remarks)},
            {"guesses", inspection.guesses},
            {"trees", measured}};
}

} // namespace raysteps
