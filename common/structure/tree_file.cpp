#include "structure/tree_file.h"

#include "basics/file.h"
#include "basics/numbers.h"
#include "basics/text.h"
#include "structure/kd_tree/build_kd_tree.h"
#include "structure/kd_tree/check_kd_tree.h"
#include "structure/padding.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <unordered_map>

namespace raysteps {

namespace {

constexpr std::string_view magic = "raysteps tree 1\n";
constexpr std::size_t most_head_bytes = 1 << 20;
constexpr std::uintmax_t most_file_bytes = std::uintmax_t{16} << 30;
constexpr std::uint64_t most_records = std::uint64_t{1} << 28;
constexpr std::uint64_t most_record_bytes = 4096;
constexpr std::size_t most_gaps = 16;
constexpr int deepest_kd_tree = 256;  // our builder's are 64 deep at most
constexpr std::size_t alignment = 16; // of the head's end and of each array

static_assert(std::endian::native == std::endian::little, "the file's numbers are little-endian");

// --- The head ---

void check_names(const Numbers& object, const std::string& what,
                 const std::vector<std::string_view>& names) {
    for (const auto& [name, value] : object.members()) {
        if (std::ranges::find(names, name) == names.end()) {
            throw InputError(what + " has a member " + in_quotes(name) + ". It may have " +
                             listed(names) + ".");
        }
    }
}

std::uint64_t whole(const Numbers& object, const std::string& name, std::uint64_t most) {
    const double number = object.at(name).number();
    if (!(number >= 0.0 && number <= static_cast<double>(most)) || number != std::floor(number)) {
        throw InputError(fmt::format("`{}` is {}, and must be a whole number from 0 to {}.", name,
                                     number, most));
    }
    return static_cast<std::uint64_t>(number);
}

std::string word(const Numbers& object, const std::string& name,
                 const std::vector<std::string_view>& words) {
    const std::string& text = object.at(name).text();
    if (std::ranges::find(words, text) == words.end()) {
        throw InputError(fmt::format("`{}` is {}, and must be one of {}.", name, in_quotes(text),
                                     listed(words)));
    }
    return text;
}

// --- Arrays ---

enum class FieldType { float32, int8, uint8, int16, uint16, int32, uint32, int64, uint64 };

struct NamedType {
    std::string_view name;
    FieldType type;
    std::uint64_t bytes;
};

constexpr std::array<NamedType, 9> field_types{{{"float32", FieldType::float32, 4},
                                                {"int8", FieldType::int8, 1},
                                                {"uint8", FieldType::uint8, 1},
                                                {"int16", FieldType::int16, 2},
                                                {"uint16", FieldType::uint16, 2},
                                                {"int32", FieldType::int32, 4},
                                                {"uint32", FieldType::uint32, 4},
                                                {"int64", FieldType::int64, 8},
                                                {"uint64", FieldType::uint64, 8}}};

// A field of an array's records: so many values side by side, from that byte of a record on.
struct RecordField {
    std::string name;
    FieldType type = FieldType::int32;
    std::uint64_t at = 0;
    std::uint64_t values = 1;
};

// Records of one size, in the bytes of the file.
struct RecordArray {
    std::string name;
    const char* bytes = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;
    std::vector<RecordField> fields{};

    const RecordField* find(const std::string& field) const {
        const auto known = std::ranges::find(fields, field, &RecordField::name);
        return known == fields.end() ? nullptr : &*known;
    }

    const RecordField& need(const std::string& field, std::uint64_t values) const {
        const RecordField* const known = find(field);
        if (known == nullptr || known->values != values) {
            throw InputError(fmt::format("the array `{}` needs a field `{}` of {} values a record.",
                                         name, field, values));
        }
        return *known;
    }
};

template <class Number>
Number value_at(const char* place) {
    Number number;
    std::memcpy(&number, place, sizeof(Number));
    return number;
}

template <class Number>
std::int32_t narrow_index(Number number) {
    constexpr auto least = std::numeric_limits<std::int32_t>::min();
    if (std::cmp_greater_equal(number, far_out)) {
        return number == std::numeric_limits<std::uint32_t>::max() ? no_child : far_out;
    }
    return std::cmp_less(number, least) ? least : static_cast<std::int32_t>(number);
}

// A whole number of a record. One that is no int32 becomes far_out, but all ones of an unsigned
// number is -1: that is how C++ writes "none".
std::int32_t index_at(const RecordArray& array, const RecordField& field, std::size_t record,
                      std::size_t value = 0) {
    const char* const first = array.bytes + record * array.stride + field.at;
    switch (field.type) {
    case FieldType::int8:
        return value_at<std::int8_t>(first + value);
    case FieldType::uint8:
        return value_at<std::uint8_t>(first + value);
    case FieldType::int16:
        return value_at<std::int16_t>(first + 2 * value);
    case FieldType::uint16:
        return value_at<std::uint16_t>(first + 2 * value);
    case FieldType::int32:
        return value_at<std::int32_t>(first + 4 * value);
    case FieldType::uint32:
        return narrow_index(value_at<std::uint32_t>(first + 4 * value));
    case FieldType::int64:
        return narrow_index(value_at<std::int64_t>(first + 8 * value));
    case FieldType::uint64: {
        const auto number = value_at<std::uint64_t>(first + 8 * value);
        return number == std::numeric_limits<std::uint64_t>::max() ? no_child
                                                                   : narrow_index(number);
    }
    case FieldType::float32:
        break;
    }
    return far_out;
}

float float_at(const RecordArray& array, const RecordField& field, std::size_t record,
               std::size_t value = 0) {
    return value_at<float>(array.bytes + record * array.stride + field.at + 4 * value);
}

const RecordField& need_floats(const RecordArray& array, const std::string& name,
                               std::uint64_t values) {
    const RecordField& field = array.need(name, values);
    if (field.type != FieldType::float32) {
        throw InputError(fmt::format("the field `{}` of `{}` is no float32. Nodes whose boxes are "
                                     "quantised or doubles are not read: write boxes as float32, "
                                     "rounded outwards.",
                                     name, array.name));
    }
    return field;
}

const RecordField& need_indices(const RecordArray& array, const std::string& name,
                                std::uint64_t values) {
    const RecordField& field = array.need(name, values);
    if (field.type == FieldType::float32) {
        throw InputError(
            fmt::format("the field `{}` of `{}` must be of whole numbers.", name, array.name));
    }
    return field;
}

glm::vec3 point_at(const RecordArray& array, const RecordField& field, std::size_t record,
                   std::size_t first = 0) {
    return {float_at(array, field, record, first), float_at(array, field, record, first + 1),
            float_at(array, field, record, first + 2)};
}

RecordField read_field(const Numbers& described, const std::string& array) {
    check_names(described, "a field of `" + array + "`", {"name", "type", "at", "values"});
    RecordField field;
    field.name = described.at("name").text();
    const std::string& type = described.at("type").text();
    const auto known = std::ranges::find(field_types, type, &NamedType::name);
    if (known == field_types.end()) {
        throw InputError(fmt::format(
            "the field {} of `{}` has the type {}. Nodes are read as float32 and as int8 to "
            "uint64: quantised boxes and doubles are not, so write boxes as float32, rounded "
            "outwards.",
            in_quotes(field.name), array, in_quotes(type)));
    }
    field.type = known->type;
    field.at = whole(described, "at", most_record_bytes);
    field.values =
        described.find("values") == nullptr ? 1 : whole(described, "values", most_record_bytes);
    return field;
}

// The array of that name within the bytes behind the head.
RecordArray read_array(const Numbers& described, const std::string& name, std::string_view data) {
    check_names(described, "the array `" + name + "`", {"at", "count", "stride", "fields"});
    RecordArray array{.name = name};
    const std::uint64_t at = whole(described, "at", most_file_bytes);
    const std::uint64_t count = whole(described, "count", most_records);
    const std::uint64_t stride = whole(described, "stride", most_record_bytes);
    for (const Numbers& field : described.at("fields").values()) {
        array.fields.push_back(read_field(field, name));
        const RecordField& read = array.fields.back();
        const auto type = std::ranges::find(field_types, read.type, &NamedType::type);
        if (read.values == 0 || read.at + read.values * type->bytes > stride) {
            throw InputError(fmt::format("the field {} of `{}` reaches beyond its record of {} "
                                         "bytes.",
                                         in_quotes(read.name), name, stride));
        }
    }
    if (at > data.size() || count * stride > data.size() - at) {
        throw InputError(fmt::format("the array `{}` needs {} bytes from byte {} behind the head "
                                     "on, and the file has {} there. It is cut short, or the head "
                                     "is wrong.",
                                     name, count * stride, at, data.size()));
    }
    array.bytes = data.data() + at;
    array.count = count;
    array.stride = stride;
    return array;
}

// --- The three kinds of trees ---

struct ReadArrays {
    const Numbers& head;
    std::string_view data;

    bool has(const std::string& name) const { return head.at("arrays").find(name) != nullptr; }

    RecordArray get(const std::string& name) const {
        const Numbers* const described = head.at("arrays").find(name);
        if (described == nullptr) {
            throw InputError("the array `" + name + "` is missing.");
        }
        return read_array(*described, name, data);
    }

    std::vector<std::int32_t> indices(const std::string& name, const std::string& field) const {
        const RecordArray array = get(name);
        const RecordField& own = need_indices(array, field, 1);
        std::vector<std::int32_t> numbers(array.count);
        for (std::size_t i = 0; i < array.count; ++i) {
            numbers[i] = index_at(array, own, i);
        }
        return numbers;
    }
};

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

// A reference says which neighbours list its triangle as well.
std::vector<std::int32_t> with_neighbours(const GridShape& shape,
                                          const std::vector<std::int32_t>& starts,
                                          const std::vector<std::int32_t>& references) {
    const auto lists = [&](std::int64_t cell, std::int32_t triangle) {
        const auto first = references.begin() + starts[static_cast<std::size_t>(cell)];
        const auto last = references.begin() + starts[static_cast<std::size_t>(cell) + 1];
        return std::binary_search(first, last, triangle);
    };
    std::vector<std::int32_t> marked = references;
    const std::array<std::int64_t, 3> steps{1, shape.cells.x,
                                            std::int64_t{shape.cells.x} * shape.cells.y};
    for (std::int64_t cell = 0; cell < cell_count(shape); ++cell) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t step = steps[static_cast<std::size_t>(axis)];
            const std::int64_t place = cell / step % shape.cells[axis];
            for (int side = 0; side < 2; ++side) {
                if (place == (side == 0 ? 0 : shape.cells[axis] - 1)) {
                    continue;
                }
                const std::int64_t neighbour = side == 0 ? cell - step : cell + step;
                for (auto r = static_cast<std::size_t>(starts[static_cast<std::size_t>(cell)]);
                     r < static_cast<std::size_t>(starts[static_cast<std::size_t>(cell) + 1]);
                     ++r) {
                    if (lists(neighbour, references[r])) {
                        marked[r] = static_cast<std::int32_t>(
                            static_cast<std::uint32_t>(marked[r]) |
                            1U << static_cast<unsigned>(triangle_bits + 2 * axis + side));
                    }
                }
            }
        }
    }
    return marked;
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

// --- Numbers of triangles ---

namespace {

// The nine floats of a triangle, from its least corner on, so that one that was turned is the same.
using TriangleBits = std::array<std::uint32_t, 9>;

TriangleBits bits_of(std::span<const glm::vec3> corners) {
    std::array<TriangleBits, 3> turned{};
    for (std::size_t turn = 0; turn < 3; ++turn) {
        for (std::size_t i = 0; i < 9; ++i) {
            const float number = corners[(turn + i / 3) % 3][static_cast<int>(i % 3)];
            turned[turn][i] = std::bit_cast<std::uint32_t>(number == 0.0f ? 0.0f : number); // no -0
        }
    }
    return *std::ranges::min_element(turned);
}

struct HashOfBits {
    std::size_t operator()(const TriangleBits& bits) const {
        std::uint64_t hash = 14695981039346656037ULL; // FNV-1a
        for (const std::uint32_t number : bits) {
            hash = (hash ^ number) * 1099511628211ULL;
        }
        return hash;
    }
};

// The number in the scene of each triangle of the file. Of equal ones, each takes the next.
std::vector<std::int32_t> numbers_in(std::span<const glm::vec3> scene,
                                     std::span<const glm::vec3> own) {
    std::unordered_multimap<TriangleBits, std::int32_t, HashOfBits> places;
    places.reserve(scene.size() / 3);
    for (std::size_t i = scene.size() / 3; i-- > 0;) {
        places.emplace(bits_of(scene.subspan(3 * i, 3)), static_cast<std::int32_t>(i));
    }
    std::vector<std::int32_t> numbers(own.size() / 3, far_out);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto [first, last] = places.equal_range(bits_of(own.subspan(3 * i, 3)));
        const auto least = std::min_element(
            first, last, [](const auto& a, const auto& b) { return a.second < b.second; });
        if (least != last) {
            numbers[i] = least->second;
            places.erase(least);
        }
    }
    return numbers;
}

std::vector<std::int32_t> translated(std::vector<std::int32_t> order,
                                     const std::vector<std::int32_t>& numbers) {
    for (std::int32_t& triangle : order) {
        triangle = triangle >= 0 && static_cast<std::size_t>(triangle) < numbers.size()
                       ? numbers[static_cast<std::size_t>(triangle)]
                       : far_out;
    }
    return order;
}

void check_references(std::span<const std::int32_t> references, std::size_t triangles) {
    for (const std::int32_t triangle : references) {
        if (triangle < 0 || static_cast<std::size_t>(triangle) >= triangles) {
            throw InputError("the tree names triangle " + std::to_string(triangle) +
                             ", and the scene has " + std::to_string(triangles) +
                             ". Is it a tree of this scene?");
        }
    }
}

// A triangle without area that the loader has dropped is missed by nobody: it is taken out of the
// leaves.
bool is_nothing(std::span<const glm::vec3> corners) {
    return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

BoxTree without_nothing(BoxTree tree, const std::vector<std::int32_t>& numbers,
                        std::span<const glm::vec3> own) {
    const auto dropped = [&](std::int32_t triangle) {
        const auto place = static_cast<std::size_t>(triangle);
        return triangle >= 0 && place < numbers.size() && numbers[place] == far_out &&
               is_nothing(own.subspan(3 * place, 3));
    };
    if (std::ranges::none_of(tree.order, dropped)) {
        return tree;
    }
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        BvhNode& leaf = tree.nodes[i];
        const std::int64_t end = std::int64_t{leaf.first} + leaf.count;
        if (!is_leaf(tree, i) || leaf.first < 0 || leaf.count < 0 ||
            end > static_cast<std::int64_t>(tree.order.size())) {
            continue;
        }
        const auto first = tree.order.begin() + leaf.first;
        leaf.count = static_cast<std::int32_t>(
            std::stable_partition(first, tree.order.begin() + end,
                                  [&](std::int32_t triangle) { return !dropped(triangle); }) -
            first);
    }
    return tree;
}

// In ascending order within each range, as the walks need it.
template <class Ends>
void sort_ranges(std::vector<std::int32_t>& references, const Ends& ends) {
    for (const auto& [first, end] : ends) {
        std::sort(references.begin() + first, references.begin() + end);
    }
}

} // namespace

AnyTree in_numbers_of(TreeFile file, std::span<const glm::vec3> corners) {
    const std::size_t triangles = corners.size() / 3;
    const std::vector<std::int32_t> numbers =
        file.corners.empty() ? std::vector<std::int32_t>{} : numbers_in(corners, file.corners);
    const auto translate = [&](std::vector<std::int32_t>& order) {
        if (!file.corners.empty()) {
            order = translated(std::move(order), numbers);
        }
    };
    std::vector<std::pair<std::int32_t, std::int32_t>> ranges;
    if (BoxTree* const boxes = std::get_if<BoxTree>(&file.tree)) {
        *boxes = without_nothing(std::move(*boxes), numbers, file.corners);
        translate(boxes->order);
    } else if (KdTree* const kd_tree = std::get_if<KdTree>(&file.tree)) {
        translate(kd_tree->references);
        check_references(kd_tree->references, triangles);
        for (const KdNode& node : kd_tree->nodes) {
            ranges.emplace_back(node.first_reference, node.end_reference);
        }
        sort_ranges(kd_tree->references, ranges);
    } else {
        Grid& grid = std::get<Grid>(file.tree);
        translate(grid.references);
        check_references(grid.references, std::min<std::size_t>(triangles, triangle_mask));
        for (std::size_t i = 0; i + 1 < grid.starts.size(); ++i) {
            ranges.emplace_back(grid.starts[i], grid.starts[i + 1]);
        }
        sort_ranges(grid.references, ranges);
        grid.references = with_neighbours(grid.shape, grid.starts, grid.references);
    }
    return std::move(file.tree);
}

// --- Writing ---

namespace {

// Arrays behind a head that describes them.
class TreeWriter {
public:
    Numbers head = empty_object();

    template <class Record>
    void add(const std::string& name, std::span<const Record> records, Numbers fields) {
        data_.resize((data_.size() + alignment - 1) / alignment * alignment, '\0');
        arrays_[name] = {{"at", data_.size()},
                         {"count", records.size()},
                         {"stride", sizeof(Record)},
                         {"fields", std::move(fields)}};
        if (!records.empty()) {
            data_.append(reinterpret_cast<const char*>(records.data()), records.size_bytes());
        }
    }

    std::string bytes() {
        head["arrays"] = arrays_;
        const std::string text = head.to_json() + "\n";
        const std::uint64_t size = text.size();
        std::string all(magic);
        all.append(reinterpret_cast<const char*>(&size), sizeof(size));
        all += text;
        all.resize((all.size() + alignment - 1) / alignment * alignment, '\0');
        return all + data_;
    }

private:
    Numbers arrays_ = empty_object();
    std::string data_;
};

Numbers field(const std::string& name, const std::string& type, std::size_t at,
              std::size_t values = 1) {
    return {{"name", name}, {"type", type}, {"at", at}, {"values", values}};
}

Numbers one_index(const std::string& name) {
    return Numbers::List{field(name, "int32", 0)};
}

bool has_pairs(const BoxTree& tree) {
    bool pairs = tree.width == 2;
    for (std::size_t i = 0; i < tree.nodes.size() && pairs; ++i) {
        const BvhNode& node = tree.nodes[i];
        const auto children = children_of(tree, i);
        pairs = is_leaf(tree, i) || (node.count == 0 && children[0] == node.first &&
                                     children[1] == std::int64_t{node.first} + 1);
    }
    return pairs;
}

void put(TreeWriter& writer, const BoxTree& tree) {
    writer.head["kind"] = "bvh";
    writer.head["children_per_node"] = tree.width;
    const bool pairs = has_pairs(tree);
    writer.head["links"] = pairs ? "pair" : "indices";
    writer.head["splits"] = tree.splits;
    writer.head["padding"] = tree.padding;
    Numbers fields =
        Numbers::List{field("lower", "float32", offsetof(BvhNode, box) + offsetof(Box, lower), 3),
                      field("upper", "float32", offsetof(BvhNode, box) + offsetof(Box, upper), 3),
                      field("first", "int32", offsetof(BvhNode, first)),
                      field("count", "int32", offsetof(BvhNode, count))};
    if (pairs) {
        writer.add<BvhNode>("nodes", tree.nodes, fields);
        return;
    }
    // Each record has its children behind the node.
    struct WideRecord {
        BvhNode node;
        std::array<std::int32_t, 8> children;
    };
    std::vector<WideRecord> records(tree.nodes.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        records[i] = {tree.nodes[i], {}};
        records[i].children.fill(no_child);
        std::ranges::copy(children_of(tree, i), records[i].children.begin());
    }
    fields.push_back(field("children", "int32", offsetof(WideRecord, children),
                           static_cast<std::size_t>(tree.width)));
    writer.add<WideRecord>("nodes", records, fields);
}

void put(TreeWriter& writer, const KdTree& tree) {
    struct KdRecord {
        std::int32_t axis;
        float split;
        std::int32_t first;
        std::int32_t count;
    };
    std::vector<KdRecord> records;
    for (const KdNode& node : tree.nodes) {
        records.push_back({node.axis, node.split,
                           is_leaf(node) ? node.first_reference : node.first_child,
                           node.end_reference - node.first_reference});
    }
    writer.head["kind"] = "kd_tree";
    writer.head["padding"] = tree.padding;
    writer.add<Box>("bounds", std::span(tree.boxes).first(1),
                    Numbers::List{field("lower", "float32", 0, 3),
                                  field("upper", "float32", sizeof(glm::vec3), 3)});
    writer.add<KdRecord>("nodes", records,
                         Numbers::List{field("axis", "int32", 0), field("split", "float32", 4),
                                       field("first", "int32", 8), field("count", "int32", 12)});
}

void put(TreeWriter& writer, const Grid& grid) {
    struct GridRecord {
        glm::vec3 lower;
        glm::vec3 cell_size;
        glm::ivec3 cells;
    };
    const GridRecord record{grid.shape.lower, grid.shape.cell_size, grid.shape.cells};
    writer.head["kind"] = "grid";
    writer.head["padding"] = grid.shape.padding;
    writer.add<GridRecord>("bounds", std::span(&record, 1),
                           Numbers::List{field("lower", "float32", 0, 3),
                                         field("cell_size", "float32", 12, 3),
                                         field("cells", "int32", 24, 3)});
    writer.add<std::int32_t>("starts", grid.starts, one_index("start"));
}

} // namespace

std::string tree_file_bytes(const TreeFile& file) {
    TreeWriter writer;
    writer.head["made_by"] = file.made_by;
    writer.head["triangles"] = file.corners.empty() ? "scene" : "inside";
    std::visit([&](const auto& tree) { put(writer, tree); }, file.tree);
    std::vector<std::int32_t> order;
    if (const auto* const boxes = std::get_if<BoxTree>(&file.tree)) {
        order = boxes->order;
    } else if (const auto* const kd_tree = std::get_if<KdTree>(&file.tree)) {
        order.assign(kd_tree->references.begin(), kd_tree->references.end());
    } else {
        for (const std::int32_t reference : std::get<Grid>(file.tree).references) {
            order.push_back(triangle_of(reference));
        }
    }
    writer.add<std::int32_t>("order", order, one_index("triangle"));
    if (!file.corners.empty()) {
        static_assert(sizeof(glm::vec3) == 12);
        struct CornerRecord {
            std::array<glm::vec3, 3> points;
        };
        std::vector<CornerRecord> triangles(file.corners.size() / 3);
        std::memcpy(triangles.data(), file.corners.data(), 36 * triangles.size());
        writer.add<CornerRecord>("corners", triangles,
                                 Numbers::List{field("points", "float32", 0, 9)});
    }
    return writer.bytes();
}

void write_tree_file(const std::filesystem::path& path, const TreeFile& file) {
    write_file(path, tree_file_bytes(file));
}

} // namespace raysteps
