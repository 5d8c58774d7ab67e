#include "hard_cases/meshes.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/bvh.h"
#include "structure/bvh/check_bvh.h"
#include "structure/kd_tree/build_kd_tree.h"
#include "structure/kd_tree/check_kd_tree.h"
#include "structure/kd_tree/kd_tree.h"
#include "trials.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raysteps {

namespace {

struct NamedSplit {
    const char* name;
    BvhSplit split;
};
constexpr std::array splits{
    NamedSplit{"bvh median", BvhSplit::median}, NamedSplit{"bvh binned", BvhSplit::binned},
    NamedSplit{"bvh sweep", BvhSplit::sweep}, NamedSplit{"bvh insertion", BvhSplit::insertion}};

// A row for a tree: its depth, which must not exceed the limit, and its faults, of which there must
// be none.
TrialRow depth_row(const std::string& method, int depth, int limit, std::size_t faults) {
    const bool right = depth <= limit && faults == 0;
    return {method,
            "C++",
            "depth " + std::to_string(limit) + " at most",
            "depth " + std::to_string(depth) + ", " + std::to_string(faults) + " faults",
            right ? Verdict::pass : Verdict::fail,
            1,
            right ? std::size_t{0} : std::size_t{1}};
}

TrialRow bvh_row(const NamedSplit& split, const std::vector<glm::vec3>& corners, int limit,
                 BvhOptions options) {
    options.split = split.split;
    const Bvh bvh = build_bvh(corners, options);
    return depth_row(split.name, measure_bvh(bvh, options).depth, limit,
                     check_bvh(bvh, corners).size());
}

int levels_of_halving(std::size_t triangles, int leaf_triangles) {
    const double leaves = std::ceil(static_cast<double>(triangles) / leaf_triangles);
    return static_cast<int>(std::ceil(std::log2(leaves)));
}

std::vector<TrialRow> equal_centers(const TrialTools& tools) {
    const int count = tools.rays > 0 ? std::clamp(tools.rays, 1000, 1000000) : 100000;
    const std::vector<glm::vec3> corners = concentric_triangles(tools.seed, count);
    const BvhOptions options;
    const int halving = levels_of_halving(static_cast<std::size_t>(count), options.leaf_triangles);
    std::vector<TrialRow> rows;
    for (const NamedSplit& split : splits) {
        const bool grows = split.split == BvhSplit::insertion;
        rows.push_back(bvh_row(split, corners, grows ? options.depth_limit : halving, options));
    }
    return rows;
}

std::vector<TrialRow> equal_triangles(const TrialTools& tools) {
    const int count = tools.rays > 0 ? std::clamp(tools.rays, 1000, 1000000) : 100000;
    const std::vector<glm::vec3> corners = copies_of_a_triangle(count).corners;
    const BvhOptions options;
    const int halving = levels_of_halving(static_cast<std::size_t>(count), options.leaf_triangles);
    std::vector<TrialRow> rows;
    for (const NamedSplit& split : splits) {
        rows.push_back(bvh_row(split, corners, halving + 1, options));
    }
    const KdTree tree = build_kd_tree(corners, {});
    const int kd_limit = 8 + static_cast<int>(1.3 * std::log2(count) + 1.0);
    rows.push_back(depth_row("kd", measure_kd_tree(tree, {}).depth, kd_limit,
                             check_kd_tree(tree, corners).size()));
    return rows;
}

std::vector<TrialRow> none_and_one(const TrialTools&) {
    std::vector<TrialRow> rows;
    const std::vector<glm::vec3> one{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<glm::vec3> point(3, glm::vec3(0.0f));
    for (const NamedSplit& split : splits) {
        for (const std::vector<glm::vec3>& corners : {std::vector<glm::vec3>{}, one, point}) {
            rows.push_back(bvh_row(split, corners, 0, {}));
        }
    }
    for (const std::vector<glm::vec3>& corners : {std::vector<glm::vec3>{}, one, point}) {
        const KdTree tree = build_kd_tree(corners, {});
        rows.push_back(depth_row("kd", measure_kd_tree(tree, {}).depth, 0,
                                 check_kd_tree(tree, corners).size()));
    }
    return rows;
}

// What the paper's BuildTree, which ends at exactly one triangle, never comes back from.
std::vector<TrialRow> missing_guards(const TrialTools& tools) {
    const int count = 1000;
    BvhOptions options;
    options.leaf_triangles = 1;
    const int limit = levels_of_halving(count, 1) + 1;
    return {bvh_row({"median: no triangle", BvhSplit::median}, {}, 0, options),
            bvh_row({"median: 1,000 copies", BvhSplit::median}, copies_of_a_triangle(count).corners,
                    limit, options),
            bvh_row({"median: one centre", BvhSplit::median},
                    concentric_triangles(tools.seed, count), limit, options)};
}

std::vector<TrialRow> doubling_sizes(const TrialTools&) {
    BvhOptions options;
    options.leaf_triangles = 1;
    options.depth_limit = 10;
    std::vector<TrialRow> rows;
    for (const NamedSplit& split : splits) {
        rows.push_back(bvh_row(split, triangles_at_powers_of_two(), 10, options));
    }
    return rows;
}

// A builder that recursed as deep would overflow the stack.
std::vector<TrialRow> chain_of_shells(const TrialTools&) {
    const int count = 20000;
    BvhOptions options;
    options.insertion_order = InsertionOrder::as_given;
    options.leaf_triangles = 1;
    options.depth_limit = 1 << 20;
    std::vector<TrialRow> rows{bvh_row(splits[3], shells(count), count - 1, options)};
    options.depth_limit = 64;
    rows.push_back(bvh_row(splits[3], shells(count), 64, options));
    return rows;
}

std::vector<TrialRow> areas_beyond_floats(const TrialTools& tools) {
    const std::vector<glm::vec3> corners = heaps_at_the_end_of_floats(tools.seed);
    std::vector<TrialRow> rows;
    for (const NamedSplit& split : splits) {
        BvhOptions options;
        options.split = split.split;
        const Bvh bvh = build_bvh(corners, options);
        const bool parted = check_bvh(bvh, corners).empty() && bvh.nodes.size() > 2 &&
                            std::max(bvh.nodes[1].box.lower.x, bvh.nodes[2].box.lower.x) > 0.0f &&
                            std::min(bvh.nodes[1].box.upper.x, bvh.nodes[2].box.upper.x) < 0.0f;
        rows.push_back(promised_row(split.name, "C++", "the heaps are split", parted ? 0 : 1, 1));
    }
    return rows;
}

// How many nodes are not reached exactly once from the root.
std::size_t count_wrong_arrivals(const Bvh& bvh) {
    std::vector<int> arrivals(bvh.nodes.size(), 0);
    std::vector<std::size_t> stack{0};
    while (!stack.empty()) {
        const std::size_t node = stack.back();
        stack.pop_back();
        ++arrivals[node];
        if (!is_leaf(bvh.nodes[node])) {
            const auto child = static_cast<std::size_t>(bvh.nodes[node].first);
            stack.insert(stack.end(), {child, child + 1});
        }
    }
    return static_cast<std::size_t>(
        std::count_if(arrivals.begin(), arrivals.end(), [](int count) { return count != 1; }));
}

std::vector<TrialRow> reached_once(const TrialTools& tools) {
    RandomNumbers numbers(tools.seed);
    const std::vector<glm::vec3> corners = random_triangles(numbers, 20000).corners;
    std::vector<TrialRow> rows;
    for (const NamedSplit& split : splits) {
        BvhOptions options;
        options.split = split.split;
        const Bvh bvh = build_bvh(corners, options);
        rows.push_back(promised_row(split.name, "C++", "each node reached once",
                                    count_wrong_arrivals(bvh), bvh.nodes.size()));
    }
    return rows;
}

} // namespace

std::vector<Trial> tree_checks() {
    return {
        {"P15", "BuildTree, for no triangle, 1,000 copies of one, and 1,000 with one centre",
         "Wang and Wen, Research of Acceleration Structures for GPU Based Ray Tracing, 2010",
         "end at one or none, and halve by number where no plane splits the centres",
         missing_guards},
        {"V1c", "triangles with the same centre: the tree is as flat as by halving", "",
         "halve by number where no plane splits the centres", equal_centers},
        {"V1e", "copies of one triangle: the same", "", "halve by number", equal_triangles},
        {"V2", "trees over no triangle, one, and one that is a point", "", "", none_and_one},
        {"V3", "triangles whose sizes double: the limit of depth holds", "",
         "halve by number below the limit", doubling_sizes},
        {"V3r", "a chain of 20,000 nodes: no builder recurses on the call stack", "",
         "a stack of one's own", chain_of_shells},
        {"V4", "surface areas that overflow a float", "", "areas in double precision",
         areas_beyond_floats},
        {"V5", "every node of a BVH is reached exactly once", "", "", reached_once},
    };
}

} // namespace raysteps
