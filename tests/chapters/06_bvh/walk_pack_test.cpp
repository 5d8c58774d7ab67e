#include "build_trees.h"
#include "catch.h"
#include "scene/shapes.h"
#include "walk_counted.h"

#include <algorithm>
#include <bit>
#include <map>

using namespace raysteps;

namespace {

struct PackedNode {
    glm::vec3 first{0.0f};
    glm::vec3 last{0.0f};
    int skip = 0;
    int link = 0;
};

glm::vec3 point_of(const glm::ivec4& texel) {
    return {std::bit_cast<float>(texel.x), std::bit_cast<float>(texel.y),
            std::bit_cast<float>(texel.z)};
}

PackedNode node_at(const PackedStructure& packed, int place) {
    const auto& texels = packed.integer_vectors.at("bvh_nodes");
    const glm::ivec4& first = texels[2 * static_cast<std::size_t>(place)];
    const glm::ivec4& last = texels[2 * static_cast<std::size_t>(place) + 1];
    return {point_of(first), point_of(last), first.w, last.w};
}

// The nodes and triangles that a walk meets which misses no box.
struct Tour {
    std::vector<int> nodes;
    std::vector<int> triangles; // their numbers in the scene
};

Tour tour_of(const PackedStructure& packed, int octant) {
    const auto& triangles = packed.integer_vectors.at("bvh_triangles");
    Tour tour;
    int place = octant * packed.numbers.at("bvh_node_count");
    while (place >= 0) {
        const PackedNode node = node_at(packed, place);
        tour.nodes.push_back(place);
        bool last = node.link < 0;
        for (auto i = static_cast<std::size_t>(std::max(node.link, 0)); !last; ++i) {
            tour.triangles.push_back(triangles[3 * i].w);
            last = triangles[3 * i + 1].w != 0;
        }
        place = node.link >= 0 ? node.skip : place + 1;
    }
    return tour;
}

std::vector<int> numbers_from(int first, int count) {
    std::vector<int> numbers;
    for (int i = 0; i < count; ++i) {
        numbers.push_back(first + i);
    }
    return numbers;
}

} // namespace

TEST_CASE("a packed tree of two triangles is as written down", "[06][known]") {
    // One at x = 0, one at x = 10: rays that descend along x meet the second one first.
    const std::vector<glm::vec3> corners{{0, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                         {10, 0, 0}, {10, 1, 0}, {10, 0, 1}};
    const Box low{{0, 0, 0}, {0, 1, 1}};
    const Box high{{10, 0, 0}, {10, 1, 1}};
    Bvh bvh;
    bvh.nodes = {{merge(low, high), 1, 0}, {high, 0, 1}, {low, 1, 1}};
    bvh.order = {1, 0};
    const PackedStructure packed = pack(bvh, corners);
    CHECK(packed.numbers.at("bvh_node_count") == 3);
    CHECK(packed.integers.at("bvh_parents") == std::vector<std::int32_t>{-1, 0, 0});

    const PackedNode root = node_at(packed, 0);
    CHECK(root.first == glm::vec3(0, 0, 0));
    CHECK(root.last == glm::vec3(10, 1, 1));
    CHECK(root.skip == -1);
    CHECK(root.link == -1 - (4 * 2 + 0)); // the second child is node 2, and they lie along x
    const PackedNode near = node_at(packed, 1);
    CHECK(near.last == glm::vec3(0, 1, 1));
    CHECK(near.skip == 2);
    CHECK(near.link == 1);
    CHECK(node_at(packed, 2).skip == -1);

    const PackedNode turned = node_at(packed, 3); // the root for rays that descend along x
    CHECK(turned.first == glm::vec3(10, 0, 0));
    CHECK(turned.last == glm::vec3(0, 1, 1));
    CHECK(turned.link == -1 - (4 * 5 + 0));
    CHECK(node_at(packed, 4).first == glm::vec3(10, 0, 0));
    CHECK(node_at(packed, 4).link == 0);
    CHECK(tour_of(packed, 0).triangles == std::vector<int>{0, 1});
    CHECK(tour_of(packed, 1).triangles == std::vector<int>{1, 0});
    CHECK(tour_of(packed, 6).triangles == std::vector<int>{0, 1});

    const auto& texels = packed.integer_vectors.at("bvh_triangles");
    CHECK(point_of(texels[4]) == corners[1]); // triangle 0 is the second in the order
    CHECK(bytes_of(packed) == 3 * (256 + 4) + 2 * 48);
}

TEST_CASE("V5 in each octant every node and every triangle is met once", "[06][hard_case]") {
    const std::vector<glm::vec3> corners = random_corners(51, 500);
    for (const BvhSplit split : all_splits) {
        const Bvh bvh = build_bvh(corners, with_split(split));
        const PackedStructure packed = pack(bvh, corners);
        const int count = static_cast<int>(bvh.nodes.size());
        for (int octant = 0; octant < 8; ++octant) {
            Tour tour = tour_of(packed, octant);
            std::sort(tour.triangles.begin(), tour.triangles.end());
            CAPTURE(static_cast<int>(split), octant);
            CHECK(tour.nodes == numbers_from(octant * count, count));
            CHECK(tour.triangles == numbers_from(0, 500));
        }
    }
}

TEST_CASE("near branches first spare a BVH walk most of its steps", "[06]") {
    const int seed = 52;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 2000));
    const mirror::SceneBuffers buffers(scene);
    const Bvh bvh = build_bvh(scene.corners, {});
    std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 1000);
    std::map<std::string, unsigned> steps;
    for_each_counted_walk(buffers, bvh, scene.corners, [&](const std::string& name, auto mirror) {
        for (const Ray& ray : rays) {
            static_cast<void>(mirror.closest_hit(mirror::to_mirror<decltype(mirror)>(ray)));
        }
        steps[name] = mirror.observer.visits;
    });
    CAPTURE(steps["bvh_skip"], steps["bvh_ordered"]);
    CHECK(3 * steps["bvh_ordered"] < 2 * steps["bvh_skip"]);
    // All three go down to the near child first, by the same rule.
    CHECK(steps["bvh_parent"] == steps["bvh_ordered"]);
    CHECK(steps["bvh_stack"] == steps["bvh_ordered"]);
    CHECK(2 * steps["bvh4"] < steps["bvh_ordered"]); // four boxes a step
}
