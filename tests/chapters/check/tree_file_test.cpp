#include "catch.h"
#include "files.h"
#include "structure/bvh/check_bvh.h"
#include "support/error_of.h"

#include <cstring>

using namespace raysteps;

namespace {

// A file of that head, which lacks its arrays' places where it wants to, and of those bytes.
std::string file_of(const std::string& head, const std::string& data) {
    const std::uint64_t size = head.size();
    std::string bytes = "raysteps tree 1\n";
    bytes.append(reinterpret_cast<const char*>(&size), sizeof(size));
    bytes += head;
    bytes.resize((bytes.size() + 15) / 16 * 16, '\0');
    return bytes + data;
}

template <class Record>
std::string bytes_of_records(const std::vector<Record>& records) {
    return {reinterpret_cast<const char*>(records.data()), records.size() * sizeof(Record)};
}

// Two leaves of one triangle each, under a root.
struct SkipNode {
    glm::vec3 lower;
    std::int32_t skip;
    glm::vec3 upper;
    std::int32_t first;
    std::int32_t count;
    std::int16_t left;
    std::int16_t right;
};

const std::vector<SkipNode> three_nodes{{{0, 0, 0}, -1, {3, 1, 1}, 1, 0, 1, 2},
                                        {{0, 0, 0}, 2, {1, 1, 1}, 0, 1, -1, -1},
                                        {{2, 0, 0}, -1, {3, 1, 1}, 1, 1, -1, -1}};

const std::string node_fields =
    R"([{"name": "lower", "type": "float32", "at": 0, "values": 3},
        {"name": "upper", "type": "float32", "at": 16, "values": 3},
        {"name": "skip", "type": "int32", "at": 12},
        {"name": "first", "type": "int32", "at": 28},
        {"name": "count", "type": "int32", "at": 32},
        {"name": "children", "type": "int16", "at": 36, "values": 2}])";

std::string three_nodes_head(const std::string& links, const std::string& fields = node_fields,
                             const std::string& more = "") {
    return R"({"kind": "bvh", "triangles": "scene", "children_per_node": 2, "links": ")" + links +
           "\"" + more + R"(, "arrays": {"nodes": {"at": 0, "count": 3, "stride": 40, "fields": )" +
           fields + R"(}, "order": {"at": 120, "count": 2, "stride": 8,
           "fields": [{"name": "triangle", "type": "uint64", "at": 0}]}}})";
}

std::string three_nodes_file(const std::string& head) {
    return file_of(head, bytes_of_records(three_nodes) +
                             bytes_of_records(std::vector<std::uint64_t>{1, 0}));
}

BoxTree boxes_in(const std::string& bytes) {
    return std::get<BoxTree>(parse_tree_file(bytes, "some.rstree").tree);
}

std::string refusal_of(const std::string& bytes) {
    return error_of([&] { parse_tree_file(bytes, "some.rstree"); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    REQUIRE(place != std::string::npos);
    return text.replace(place, from.size(), to);
}

const std::vector<glm::vec3> two_triangles{{2, 0, 0}, {3, 1, 0}, {2, 0, 1},
                                           {0, 0, 0}, {1, 1, 0}, {0, 0, 1}};

} // namespace

TEST_CASE("nodes are read by their fields, whatever links them", "[check][file]") {
    static_assert(sizeof(SkipNode) == 40);
    for (const std::string links : {"pair", "indices", "skip"}) {
        CAPTURE(links);
        const BoxTree tree = boxes_in(three_nodes_file(three_nodes_head(links)));
        CHECK(tree.children == std::vector<std::int32_t>{1, 2, -1, -1, -1, -1});
        CHECK(tree.order == std::vector<std::int32_t>{1, 0});
        CHECK(tree.nodes[2].box.lower == glm::vec3(2, 0, 0));
        CHECK(find_faults(tree, two_triangles, 0.0).faults.kinds.empty());
        CHECK(bvh_of(tree, 2).nodes.size() == 3);
    }
}

TEST_CASE("numbers of triangles inside the file are found again in the scene", "[check][file]") {
    std::vector<glm::vec3> turned{two_triangles[1], two_triangles[2], two_triangles[0],
                                  {9, 9, 9},        {9, 9, 9},        {8, 8, 8},
                                  two_triangles[3], two_triangles[4], two_triangles[5]};
    BoxTree tree = boxes_in(three_nodes_file(three_nodes_head("pair")));
    tree.nodes[1].count = 2; // one of its triangles is none, and the loader has dropped it
    tree.nodes[2].first = 2;
    tree.order = {1, 2, 0};
    const TreeFile file =
        parse_tree_file(tree_file_bytes({"a test", tree, turned}), "inside.rstree");
    const AnyTree known = in_numbers_of(file, two_triangles);
    CHECK(find_faults(std::get<BoxTree>(known), two_triangles, 0.0).faults.kinds.empty());
    CHECK(std::get<BoxTree>(known).nodes[1].count == 1);
    turned[0].x += 1.0f; // no triangle of the scene
    const AnyTree other = in_numbers_of({"a test", tree, turned}, two_triangles);
    CHECK(count_of(find_faults(std::get<BoxTree>(other), two_triangles, 0.0).faults,
                   fault_of_triangle) == 1);
}

TEST_CASE("a file that ends anywhere is told in one sentence with its name", "[check][file]") {
    const std::string whole = three_nodes_file(three_nodes_head("pair"));
    REQUIRE(refusal_of(whole).empty());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const std::string refusal = refusal_of(whole.substr(0, size));
        CAPTURE(size, refusal);
        CHECK_THAT(refusal, starts_with_text("some.rstree: "));
    }
}

TEST_CASE("what a tree file cannot be is refused in words", "[check][file]") {
    const std::string head = three_nodes_head("pair");
    const auto told = [&](const std::string& from, const std::string& to, const std::string& what) {
        CAPTURE(from, to);
        CHECK_THAT(refusal_of(three_nodes_file(replaced(head, from, to))), contains_text(what));
    };
    told("\"bvh\"", "\"two_level\"", "two levels");
    told("\"bvh\"", "\"quadtree\"", "one of bvh, kd_tree, grid");
    told("float32", "float64", "quantised");
    told("float32", "uint8", "rounded outwards");
    told("\"children_per_node\": 2", "\"children_per_node\": 3", "2, 4 or 8");
    told("\"children_per_node\": 2", "\"children_per_node\": 4", "goes with 2");
    told("\"pair\"", "\"loop\"", "one of pair, indices, skip");
    told("\"scene\"", "\"file\"", "one of scene, inside");
    told("\"scene\"", "\"inside\"", "`corners` is missing");
    told("\"count\": 3", "\"count\": 4", "cut short");
    told("\"count\": 3", "\"count\": 268435457", "0 to 268435456");
    told("\"count\": 3", "\"count\": -1", "whole number");
    told("\"count\": 3", "\"count\": 1e300", "whole number");
    told("\"at\": 120", "\"at\": 17179869184", "cut short");
    told("\"stride\": 40", "\"stride\": 32", "beyond its record");
    told("\"values\": 3", "\"values\": 2", "needs a field `lower` of 3");
    told("\"triangles\"", "\"tringles\"", "tringles");
    told("\"links\"", "\"padding\": -1, \"links\"", "0 or more");
    CHECK_THAT(refusal_of("solid cube"), contains_text("no tree file"));
    CHECK_THAT(refusal_of(file_of(std::string(5000, '['), "")), contains_text("deeper than"));
    CHECK_THAT(refusal_of(file_of("{", "")), contains_text("no JSON"));
}

TEST_CASE("whatever is flipped in a file, it ends in a tree or in a sentence", "[check][file]") {
    const int seed = 11;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const std::vector<std::string> files{three_nodes_file(three_nodes_head("pair")),
                                         three_nodes_file(three_nodes_head("indices")),
                                         three_nodes_file(three_nodes_head("skip"))};
    std::size_t trees = 0;
    std::size_t walked = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string bytes = files[static_cast<std::size_t>(i) % files.size()];
        // In the head, nearly every change is told at once: more of them in the arrays.
        const int size = static_cast<int>(bytes.size());
        const int first = i % 4 == 0 ? 0 : size - 136;
        for (int flips = 0; flips < 3; ++flips) {
            bytes[static_cast<std::size_t>(first + numbers.below(size - first))] =
                static_cast<char>(numbers.below(i % 2 == 0 ? 256 : 4));
        }
        error_of([&] {
            const BoxTree tree = boxes_in(bytes);
            ++trees;
            find_faults(tree, two_triangles, 0.0);
            measure_box_tree(tree, {});
            pack(bvh_of(tree, 2), two_triangles);
            ++walked;
        });
    }
    CHECK(trees > 300);
    CHECK(walked > 100);
    CHECK(walked < trees);
}
