#include "build_trees.h"
#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "mirror/walks.h"
#include "scene/shapes.h"
#include "support/error_of.h"
#include "support/mirror_hits.h"

#include <rapidcheck.h>

#include <algorithm>
#include <limits>

using namespace raysteps;

TEST_CASE("random triangles on a lattice make trees without faults", "[06][build][property]") {
    REQUIRE(rc::check([] {
        RandomNumbers numbers(*rc::gen::inRange(0, 1 << 20));
        const auto count = *rc::gen::inRange(0, 80);
        const auto steps = *rc::gen::inRange(1, 6); // few: many equal centres, some flat triangles
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 3 * count; ++i) {
            const glm::vec3 corner(numbers.below(steps), numbers.below(steps),
                                   numbers.below(steps));
            corners.insert(corners.end(), corner);
        }
        for (const BvhSplit split : all_splits) {
            BvhOptions options = with_split(split);
            options.leaf_triangles = *rc::gen::inRange(1, 6);
            options.depth_limit = *rc::gen::inRange(0, 12);
            options.bins = *rc::gen::inRange(2, 20);
            const Bvh bvh = build_bvh(corners, options);
            RC_ASSERT(first_fault(bvh, corners) == "");
            const int halving = count == 0 ? 0 : levels_of_halving(corners.size() / 3, options);
            RC_ASSERT(measure_bvh(bvh, options).depth <= std::max(options.depth_limit, halving));
        }
    }));
}

TEST_CASE("each hit lies in the boxes of all nodes above its triangle", "[06][build][property]") {
    const int seed = 61;
    CAPTURE(seed);
    using Loop = mirror::walks::every_triangle<float>;
    for (const float offset : {0.0f, 1000.0f}) { // where coordinates are coarse
        RandomNumbers numbers(seed);
        Scene scene;
        scene = add_mesh(scene, sphere(glm::vec3(offset), 1.0f, 4), {});
        for (const RayFamily& family : ray_families(numbers, scene.corners, 500)) {
            const std::vector<Hit> hits = mirror_hits<Loop>(scene, family.rays);
            for (const BvhSplit split : all_splits) {
                const Bvh bvh = build_bvh(scene.corners, with_split(split));
                std::vector<Box> boxes(scene.corners.size() / 3); // of each triangle's leaf
                for (const BvhNode& node : bvh.nodes) {
                    for (int i = node.first; i < node.first + node.count; ++i) {
                        boxes[static_cast<std::size_t>(bvh.order[static_cast<std::size_t>(i)])] =
                            node.box;
                    }
                }
                int hit_count = 0;
                int outside = 0;
                for (std::size_t i = 0; i < hits.size(); ++i) {
                    if (hits[i].triangle < 0) {
                        continue;
                    }
                    ++hit_count;
                    const Box& box = boxes[static_cast<std::size_t>(hits[i].triangle)];
                    const Ray& ray = family.rays[i];
                    for (int axis = 0; axis < 3; ++axis) {
                        const double at = static_cast<double>(ray.origin[axis]) +
                                          static_cast<double>(hits[i].t) *
                                              static_cast<double>(ray.direction[axis]);
                        outside += at >= static_cast<double>(box.lower[axis]) &&
                                           at <= static_cast<double>(box.upper[axis])
                                       ? 0
                                       : 1;
                    }
                }
                CAPTURE(family.name, offset, static_cast<int>(split));
                CHECK(outside == 0);
                CHECK(hit_count > 50);
            }
        }
    }
}

TEST_CASE("a tree is the same for any number of threads", "[06][build]") {
    const std::vector<glm::vec3> corners = random_corners(6, 30000);
    for (const BvhSplit split : all_splits) {
        BvhOptions options = with_split(split);
        options.threads = 1;
        const Bvh alone = build_bvh(corners, options);
        CHECK(first_fault(alone, corners).empty());
        for (const unsigned threads : {0U, 2U, 5U}) {
            options.threads = threads;
            CAPTURE(static_cast<int>(split), threads);
            CHECK(same_tree(build_bvh(corners, options), alone));
        }
    }
}

TEST_CASE("the heuristic makes cheaper trees than medians and insertion", "[06][build]") {
    const std::vector<glm::vec3> corners = random_corners(7, 3000);
    std::array<double, 4> costs{};
    for (const BvhSplit split : all_splits) {
        const BvhOptions options = with_split(split);
        costs[static_cast<std::size_t>(split)] =
            measure_bvh(build_bvh(corners, options), options).cost;
    }
    const auto [median, insertion, binned, sweep] = costs;
    CAPTURE(median, insertion, binned, sweep);
    CHECK(binned < 0.9 * median);
    CHECK(binned < 0.9 * insertion);
    CHECK(std::abs(binned - sweep) < 0.05 * sweep);
}

TEST_CASE("options and corners that make no sense are named", "[06][build]") {
    const std::vector<glm::vec3> corners = random_corners(8, 10);
    const auto error_with = [&](auto change) {
        BvhOptions options;
        change(options);
        return error_of([&] { build_bvh(corners, options); });
    };
    CHECK_THAT(error_with([](BvhOptions& options) { options.bins = 1; }), contains_text("--bins"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.bins = 257; }),
               contains_text("--bins"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.leaf_triangles = 0; }),
               contains_text("--leaf-triangles"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.depth_limit = -1; }),
               contains_text("--depth"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.traversal_cost = std::nan(""); }),
               contains_text("--traversal-cost"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.intersection_cost = -1.0; }),
               contains_text("--intersection-cost"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.reach = INFINITY; }),
               contains_text("reach"));
    CHECK_THAT(error_with([](BvhOptions& options) { options.memory_limit = 679; }),
               contains_text("--memory-limit"));
    CHECK(error_with([](BvhOptions& options) { options.memory_limit = 680; }).empty());
    for (const float wrong : {std::nanf(""), INFINITY, 1.1e37f}) {
        std::vector<glm::vec3> broken = corners;
        broken[4].y = wrong;
        CHECK_THAT(error_of([&] { build_bvh(broken, {}); }), contains_text("Triangle 1 "));
    }
}
