#include "build_trees.h"
#include "catch.h"
#include "hard_cases/meshes.h"

#include <span>

using namespace raysteps;

namespace {

// The area of the smallest box around some triangles, from their corners, with room on every side.
double area_around(std::span<const int> triangles, std::span<const glm::vec3> corners,
                   double padding) {
    glm::dvec3 lower(1e300);
    glm::dvec3 upper(-1e300);
    for (const int triangle : triangles) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const glm::dvec3 point(corners[3 * static_cast<std::size_t>(triangle) + corner]);
            lower = glm::min(lower, point - padding);
            upper = glm::max(upper, point + padding);
        }
    }
    const glm::dvec3 size = upper - lower;
    return 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

// The triangles of a whole branch, by going down to its leaves.
std::vector<int> triangles_under(const Bvh& bvh, std::size_t branch) {
    std::vector<int> triangles;
    std::vector<std::size_t> waiting{branch};
    while (!waiting.empty()) {
        const BvhNode& node = bvh.nodes[waiting.back()];
        waiting.pop_back();
        const auto first = static_cast<std::size_t>(node.first);
        if (!is_leaf(node)) {
            waiting.insert(waiting.end(), {first, first + 1});
            continue;
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(node.count); ++i) {
            triangles.push_back(bvh.order[first + i]);
        }
    }
    return triangles;
}

// What a ray through the whole box is expected to cost, from the definition alone: it meets a
// branch with the probability S_branch / S_whole.
double cost_by_definition(const Bvh& bvh, std::span<const glm::vec3> corners,
                          const BvhOptions& options) {
    const double whole = area_around(triangles_under(bvh, 0), corners, bvh.padding);
    double cost = 0.0;
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const std::vector<int> triangles = triangles_under(bvh, i);
        const double probability = area_around(triangles, corners, bvh.padding) / whole;
        const double work = is_leaf(bvh.nodes[i])
                                ? options.intersection_cost * static_cast<double>(triangles.size())
                                : options.traversal_cost;
        cost += probability * work;
    }
    return cost;
}

} // namespace

TEST_CASE("two cubes side by side cost what the formula says", "[06][build]") {
    // Two triangles whose boxes are unit cubes at 0 and at 3: the whole is 4 x 1 x 1.
    std::vector<glm::vec3> corners = triangle_around(glm::vec3(0.5f), glm::vec3(0.5f));
    const std::vector<glm::vec3> far = triangle_around({3.5f, 0.5f, 0.5f}, glm::vec3(0.5f));
    corners.insert(corners.end(), far.begin(), far.end());
    BvhOptions options;
    options.leaf_triangles = 1;
    options.traversal_cost = 2.0;
    options.intersection_cost = 10.0;
    const Bvh bvh = build_bvh(corners, options);
    REQUIRE(bvh.nodes.size() == 3);
    // S_whole = 2 (4 + 1 + 4) = 18, S_cube = 6, and 2 + 2 * 10 * 6 / 18 = 26 / 3. The padding moves
    // each of the sides, of 1 and 4, by twice its amount.
    CHECK(measure_bvh(bvh, options).cost ==
          Approx(26.0 / 3.0).margin(26.0 / 3.0 * 12 * bvh.padding));
}

TEST_CASE("the cost of a tree is that of its definition by every rule", "[06][build]") {
    const std::vector<glm::vec3> corners = random_corners(72, 200);
    for (const BvhSplit split : all_splits) {
        const BvhOptions options = with_split(split);
        const Bvh bvh = build_bvh(corners, options);
        CAPTURE(static_cast<int>(split));
        // Boxes are floats, rounded outwards: a plane moves by at most 2^-23 of its coordinate,
        // at least 16 times less than the padding. What the padding does to the cost, 16 of its
        // parts do by less.
        const double expected = cost_by_definition(bvh, corners, options);
        Bvh bare = bvh;
        bare.padding = 0.0;
        const double room = std::abs(expected - cost_by_definition(bare, corners, options));
        REQUIRE(room < 1e-3 * expected);
        CHECK(measure_bvh(bvh, options).cost == Approx(expected).margin(room));
    }
}
