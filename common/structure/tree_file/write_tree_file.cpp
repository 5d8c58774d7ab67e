#include "structure/tree_file/record_arrays.h"
#include "structure/tree_file/tree_file.h"

#include "basics/file.h"

#include <algorithm>
#include <cstring>

namespace raysteps {

namespace {

// Arrays behind a head that describes them.
class TreeWriter {
public:
    Numbers head = empty_object();

    template <class Record>
    void add(const std::string& name, std::span<const Record> records, Numbers fields) {
        data_.resize((data_.size() + records::alignment - 1) / records::alignment *
                         records::alignment,
                     '\0');
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
        std::string all(records::magic);
        all.append(reinterpret_cast<const char*>(&size), sizeof(size));
        all += text;
        all.resize((all.size() + records::alignment - 1) / records::alignment * records::alignment,
                   '\0');
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
