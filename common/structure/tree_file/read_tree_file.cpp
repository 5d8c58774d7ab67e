#include "structure/tree_file/record_arrays.h"
#include "structure/tree_file/tree_file.h"

#include "basics/file.h"
#include "basics/text.h"
#include "structure/kd_tree/build_kd_tree.h"
#include "structure/kd_tree/check_kd_tree.h"
#include "structure/padding.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace raysteps {

using namespace records;

namespace {

constexpr std::size_t most_head_bytes = 1 << 20;
constexpr std::size_t most_gaps = 16;
constexpr int deepest_kd_tree = 256; // our builder's are 64 deep at most

double padding_of(const Numbers& head) {
    const Numbers* const given = head.find("padding");
    const double padding = given == nullptr ? 0.0 : given->number();
    if (!(padding >= 0.0 && padding < 1e30)) {
        throw InputError("`padding` must be 0 or more.");
    }
    return padding;
}

// A node's children are those that its skip pointer leaves out: the next one, then where each
// leads.
void link_by_skips(BoxTree& tree, const std::vector<std::int32_t>& skips) {
    const auto count = static_cast<std::int64_t>(tree.nodes.size());
    const auto width = static_cast<std::size_t>(tree.width);
    const auto end_of = [&](std::int64_t node) -> std::int64_t {
        const std::int32_t skip = skips[static_cast<std::size_t>(node)];
        return skip < 0 ? count : skip;
    };
    for (std::int64_t i = 0; i < count; ++i) {
        const auto node = static_cast<std::size_t>(i);
        if (tree.nodes[node].count > 0) {
            continue;
        }
        std::int64_t child = i + 1;
        for (std::size_t place = 0; place < width && child != end_of(i); ++place) {
            const bool inside = child > i && child < count;
            tree.children[width * node + place] =
                inside ? static_cast<std::int32_t>(child) : far_out;
            if (!inside) {
                break;
            }
            child = end_of(child);
        }
        if (child != end_of(i)) { // more children than there is room for, or a way that leads back
            tree.children[width * node + width - 1] = far_out;
        }
    }
}

BoxTree read_boxes(const ReadArrays& arrays) {
    const Numbers& head = arrays.head;
    BoxTree tree;
    tree.width = static_cast<int>(whole(head, "children_per_node", 8));
    if (tree.width != 2 && tree.width != 4 && tree.width != 8) {
        throw InputError("`children_per_node` must be 2, 4 or 8.");
    }
    const auto width = static_cast<std::size_t>(tree.width);
    tree.padding = padding_of(head);
    if (const Numbers* const splits = head.find("splits")) {
        const bool* const value = std::get_if<bool>(&splits->value());
        if (value == nullptr) {
            throw InputError("`splits` must be true or false.");
        }
        tree.splits = *value;
    }
    const std::string links = word(head, "links", {"pair", "indices", "skip"});
    if (links == "pair" && tree.width != 2) {
        throw InputError("`links` is \"pair\", which goes with 2 children a node.");
    }
    const RecordArray nodes = arrays.get("nodes");
    const RecordField& lower = need_floats(nodes, "lower", 3);
    const RecordField& upper = need_floats(nodes, "upper", 3);
    const RecordField& first = need_indices(nodes, "first", 1);
    const RecordField& count = need_indices(nodes, "count", 1);
    tree.nodes.resize(nodes.count);
    tree.children.assign(width * nodes.count, no_child);
    for (std::size_t i = 0; i < nodes.count; ++i) {
        tree.nodes[i] = {{point_at(nodes, lower, i), point_at(nodes, upper, i)},
                         index_at(nodes, first, i),
                         index_at(nodes, count, i)};
    }
    if (links == "pair") {
        for (std::size_t i = 0; i < nodes.count; ++i) {
            const BvhNode& node = tree.nodes[i];
            if (node.count == 0) {
                tree.children[2 * i] = node.first == no_child ? far_out : node.first;
                tree.children[2 * i + 1] = node.first == far_out ? far_out : node.first + 1;
            }
        }
    } else if (links == "indices") {
        const RecordField& children = need_indices(nodes, "children", width);
        for (std::size_t i = 0; i < nodes.count; ++i) {
            for (std::size_t place = 0; place < width; ++place) {
                tree.children[width * i + place] = index_at(nodes, children, i, place);
            }
        }
    } else {
        const RecordField& skip = need_indices(nodes, "skip", 1);
        std::vector<std::int32_t> skips(nodes.count);
        for (std::size_t i = 0; i < nodes.count; ++i) {
            skips[i] = index_at(nodes, skip, i);
        }
        link_by_skips(tree, skips);
    }
    tree.order = arrays.indices("order", "triangle");
    if (const Numbers* const gaps = head.find("gaps")) {
        if (gaps->values().size() > most_gaps) {
            throw InputError("`gaps` names more than " + std::to_string(most_gaps) + " nodes.");
        }
        for (const Numbers& gap : gaps->values()) {
            const double number = gap.number();
            tree.gaps.push_back(number >= 0.0 && number < 2147483647.0
                                    ? static_cast<std::int32_t>(number)
                                    : far_out);
        }
    }
    return tree;
}

[[noreturn]] void refuse_unsound(const std::string& kind, const std::string& fault) {
    throw InputError("the " + kind + " is not sound: " + fault +
                     " Its walks might never end. Check how the file was written.");
}

KdTree read_kd_tree(const ReadArrays& arrays) {
    KdTree tree;
    tree.padding = padding_of(arrays.head);
    const RecordArray bounds = arrays.get("bounds");
    if (bounds.count != 1) {
        throw InputError("the array `bounds` has one record, the box of the root.");
    }
    const Box root{point_at(bounds, need_floats(bounds, "lower", 3), 0),
                   point_at(bounds, need_floats(bounds, "upper", 3), 0)};
    const RecordArray nodes = arrays.get("nodes");
    const RecordField& axis = need_indices(nodes, "axis", 1);
    const RecordField& split = need_floats(nodes, "split", 1);
    const RecordField& first = need_indices(nodes, "first", 1);
    const RecordField& count = need_indices(nodes, "count", 1);
    tree.references = arrays.indices("order", "triangle");
    tree.nodes.resize(nodes.count);
    tree.boxes.resize(nodes.count);
    if (nodes.count == 0) {
        refuse_unsound("kd-tree", "it has no root.");
    }
    tree.boxes[0] = root;
    std::vector<char> reached(nodes.count, 0);
    reached[0] = 1;
    std::vector<int> depths(nodes.count, 0);
    std::int64_t listed = 0;
    for (std::size_t i = 0; i < nodes.count; ++i) {
        KdNode& node = tree.nodes[i];
        node.axis = index_at(nodes, axis, i);
        const std::int32_t start = index_at(nodes, first, i);
        if (node.axis == kd_leaf) {
            const std::int64_t end = std::int64_t{start} + index_at(nodes, count, i);
            if (start < 0 || end < start ||
                end > static_cast<std::int64_t>(tree.references.size())) {
                refuse_unsound("kd-tree",
                               "leaf " + std::to_string(i) + " has references outside the list.");
            }
            listed += end - start;
            if (listed > static_cast<std::int64_t>(tree.references.size())) {
                refuse_unsound("kd-tree", "leaf " + std::to_string(i) + " shares references.");
            }
            node.first_reference = start;
            node.end_reference = static_cast<int>(end);
            continue;
        }
        node.split = float_at(nodes, split, i);
        node.first_child = start;
        if (node.axis < 0 || node.axis > 2 || start <= static_cast<std::int64_t>(i) ||
            static_cast<std::size_t>(start) + 1 >= nodes.count || reached[i] == 0 ||
            reached[static_cast<std::size_t>(start)] != 0 ||
            reached[static_cast<std::size_t>(start) + 1] != 0) {
            refuse_unsound("kd-tree", "node " + std::to_string(i) +
                                          " has no axis, or children that do not stand behind it "
                                          "and under it alone.");
        }
        if (depths[i] >= deepest_kd_tree) {
            refuse_unsound("kd-tree", "it is deeper than " + std::to_string(deepest_kd_tree) + ".");
        }
        const auto child = static_cast<std::size_t>(start);
        for (std::size_t side = 0; side < 2; ++side) {
            reached[child + side] = 1;
            depths[child + side] = depths[i] + 1;
            tree.nodes[child + side].parent = static_cast<int>(i);
            tree.boxes[child + side] = tree.boxes[i];
        }
        tree.boxes[child].upper[node.axis] = node.split;
        tree.boxes[child + 1].lower[node.axis] = node.split;
    }
    for (const KdFaults& faults : {faults_of_links(tree), faults_of_boxes(tree)}) {
        if (!faults.empty()) {
            refuse_unsound("kd-tree", faults.front());
        }
    }
    return with_ropes(std::move(tree));
}

Grid read_grid(const ReadArrays& arrays) {
    Grid grid;
    grid.shape.padding = padding_of(arrays.head);
    const RecordArray bounds = arrays.get("bounds");
    if (bounds.count != 1) {
        throw InputError("the array `bounds` has one record, the corner and the cells of the "
                         "grid.");
    }
    grid.shape.lower = point_at(bounds, need_floats(bounds, "lower", 3), 0);
    grid.shape.cell_size = point_at(bounds, need_floats(bounds, "cell_size", 3), 0);
    const RecordField& cells = need_indices(bounds, "cells", 3);
    std::int64_t count = 1;
    for (int axis = 0; axis < 3; ++axis) {
        grid.shape.cells[axis] = index_at(bounds, cells, 0, static_cast<std::size_t>(axis));
        count *= std::clamp(grid.shape.cells[axis], 0, 1 << 20);
        const float size = grid.shape.cell_size[axis];
        if (grid.shape.cells[axis] < 1 || grid.shape.cells[axis] > 1 << 20 ||
            count > static_cast<std::int64_t>(most_records) || !(size > 0.0f) ||
            !std::isfinite(size) || !std::isfinite(grid.shape.lower[axis])) {
            refuse_unsound("grid", "along an axis it has no cells, or too many of them.");
        }
        for (int i = 0; i < grid.shape.cells[axis]; ++i) {
            if (!(grid_plane(grid.shape.lower[axis], size, i) <
                  grid_plane(grid.shape.lower[axis], size, i + 1))) {
                refuse_unsound("grid", "its planes do not ascend.");
            }
        }
    }
    grid.starts = arrays.indices("starts", "start");
    grid.references = arrays.indices("order", "triangle");
    if (static_cast<std::int64_t>(grid.starts.size()) != count + 1 || grid.starts.front() != 0 ||
        static_cast<std::size_t>(grid.starts.back()) != grid.references.size() ||
        !std::ranges::is_sorted(grid.starts)) {
        refuse_unsound("grid", "the starts are not those of its cells.");
    }
    return grid;
}

std::vector<glm::vec3> read_corners(const ReadArrays& arrays) {
    const RecordArray array = arrays.get("corners");
    const RecordField& points = need_floats(array, "points", 9);
    std::vector<glm::vec3> corners(3 * array.count);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = point_at(array, points, i / 3, 3 * (i % 3));
    }
    return corners;
}

TreeFile read_parts(std::string_view bytes, const std::filesystem::path& path) {
    if (!bytes.starts_with(magic)) {
        throw InputError("this is no tree file: it does not begin with \"raysteps tree 1\".");
    }
    if (bytes.size() < magic.size() + sizeof(std::uint64_t)) {
        throw InputError("the file ends before its head.");
    }
    const auto head_bytes = value_at<std::uint64_t>(bytes.data() + magic.size());
    const std::size_t start = magic.size() + sizeof(std::uint64_t);
    if (head_bytes > most_head_bytes || head_bytes > bytes.size() - start) {
        throw InputError("the head is said to have " + std::to_string(head_bytes) +
                         " bytes, and the file has " + std::to_string(bytes.size() - start) +
                         " behind its start.");
    }
    const Numbers head = parse_json(std::string(bytes.substr(start, head_bytes)), path);
    check_names(head, "the head",
                {"kind", "made_by", "children_per_node", "links", "splits", "gaps", "padding",
                 "triangles", "arrays"});
    const std::string kind = head.at("kind").text();
    if (kind == "two_level") {
        throw InputError("trees of two levels are not read. Write one tree with all triangles in "
                         "world space.");
    }
    word(head, "kind", {"bvh", "kd_tree", "grid"});
    const std::size_t behind =
        std::min(bytes.size(), (start + head_bytes + alignment - 1) / alignment * alignment);
    const ReadArrays arrays{head, bytes.substr(behind)};
    TreeFile file;
    if (const Numbers* const made_by = head.find("made_by")) {
        file.made_by = made_by->text().substr(0, 200);
    }
    if (word(head, "triangles", {"scene", "inside"}) == "inside") {
        file.corners = read_corners(arrays);
    }
    if (kind == "bvh") {
        file.tree = read_boxes(arrays);
    } else if (kind == "kd_tree") {
        file.tree = read_kd_tree(arrays);
    } else {
        file.tree = read_grid(arrays);
    }
    return file;
}

} // namespace

TreeFile parse_tree_file(std::string_view bytes, const std::filesystem::path& path) {
    try {
        return read_parts(bytes, path);
    } catch (const InputError& error) {
        const std::string what = error.what();
        throw InputError(what.starts_with(path.string()) ? what : path.string() + ": " + what);
    }
}

std::string asked_tree(const BuildRequest& request) {
    const auto asked = request.values.find(tree_option.name);
    if (asked == request.values.end()) {
        return "";
    }
    for (const auto& [name, value] : request.values) {
        // The costs are those by which the tree is measured.
        if (name != tree_option.name && name != "traversal-cost" && name != "intersection-cost") {
            throw InputError("--" + name + " " + value + ": the tree is that of " + asked->second +
                             ", and nothing is built. Leave it out.");
        }
    }
    return asked->second;
}

TreeFile read_tree_file(const std::filesystem::path& path) {
    return parse_tree_file(read_file(path, most_file_bytes), path);
}

std::string kind_of(const AnyTree& tree) {
    return std::holds_alternative<BoxTree>(tree)  ? "a hierarchy of boxes"
           : std::holds_alternative<KdTree>(tree) ? "a kd-tree"
                                                  : "a grid";
}

} // namespace raysteps
