#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "kd_hits.h"
#include "scene/shapes.h"

#include <algorithm>

using namespace raysteps;

namespace {

// What one walk did.
struct Record {
    std::vector<int> leaves; // in order
    std::vector<int> tested;
};

bool operator==(const Record& a, const Record& b) {
    return a.leaves == b.leaves && a.tested == b.tested;
}

template <class Mirror>
Record record_of(Mirror mirror, const KdTree& tree, const Ray& ray) {
    static_cast<void>(mirror.closest_hit(mirror::to_mirror<Mirror>(ray)));
    Record record;
    for (const int place : mirror.observer.visited) {
        if (is_leaf(tree.nodes[static_cast<std::size_t>(place)])) {
            record.leaves.push_back(place);
        }
    }
    record.tested = mirror.observer.tested;
    return record;
}

// The leaves that a ray comes to, by looking at every node of the tree: those whose part of the ray
// is longer than a point. The parts are made with the same expressions, but from the boxes.
std::vector<int> leaves_along(const KdTree& tree, const Ray& ray) {
    std::vector<std::pair<float, int>> found;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (!is_leaf(tree.nodes[i])) {
            continue;
        }
        const Box& box = tree.boxes[i];
        float entry = ray.t_min;
        float exit = ray.t_max;
        for (int axis = 0; axis < 3; ++axis) {
            const bool up = ray.direction[axis] > 0.0f;
            const float near = up ? box.lower[axis] : box.upper[axis];
            const float far = up ? box.upper[axis] : box.lower[axis];
            entry = std::max(entry, (near - ray.origin[axis]) / ray.direction[axis]);
            exit = std::min(exit, (far - ray.origin[axis]) / ray.direction[axis]);
        }
        if (entry < exit) {
            found.emplace_back(entry, static_cast<int>(i));
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<int> leaves;
    for (const auto& [entry, leaf] : found) {
        leaves.push_back(leaf);
    }
    return leaves;
}

} // namespace

TEST_CASE("all walks test the same triangles in the same order", "[05][order]") {
    const int seed = 31;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 300));
    for (const KdOptions& options : {KdOptions{}, with_median(), with_small_leaves()}) {
        const KdTree tree = build_kd_tree(scene.corners, options);
        const mirror::SceneBuffers buffers(scene);
        const PackedStructure packed = pack(tree);
        const auto restart =
            mirror::mirror_of<mirror::walks::kd_restart<float, Trail>>(buffers, packed);
        const auto backtrack =
            mirror::mirror_of<mirror::walks::kd_backtrack<float, Trail>>(buffers, packed);
        const auto short_stack =
            mirror::mirror_of<mirror::walks::kd_short_stack<float, Trail>>(buffers, packed);
        const auto ropes =
            mirror::mirror_of<mirror::walks::kd_ropes<float, Trail>>(buffers, packed);
        std::vector<RayFamily> families = ray_families(numbers, scene.corners, 200);
        for (RayFamily& family : tree_families(numbers, tree, scene.corners, 200)) {
            families.push_back(std::move(family));
        }
        std::size_t leaves = 0;
        for (const RayFamily& family : families) {
            std::size_t backtrack_differs = 0;
            std::size_t short_stack_differs = 0;
            std::size_t ropes_differ = 0;
            for (const Ray& ray : family.rays) {
                const Record expected = record_of(restart, tree, ray);
                leaves += expected.leaves.size();
                backtrack_differs += record_of(backtrack, tree, ray) == expected ? 0 : 1;
                short_stack_differs += record_of(short_stack, tree, ray) == expected ? 0 : 1;
                // A rope may lead over a leaf that is only touched: it is entered, not tested.
                ropes_differ += record_of(ropes, tree, ray).tested == expected.tested ? 0 : 1;
            }
            CAPTURE(family.name);
            CHECK(backtrack_differs == 0);
            CHECK(short_stack_differs == 0);
            CHECK(ropes_differ == 0);
        }
        CHECK(leaves > 5000); // of 2400 rays
    }
}

TEST_CASE("a walk comes to each leaf along the ray once and to no other", "[05][order]") {
    const int seed = 32;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene triangles = scene_of(random_triangles(numbers, 150));
    const KdTree tree = build_kd_tree(triangles.corners, with_small_leaves());
    // All triangles are moved away from their leaves, so that no hit ends a walk before the end.
    Scene nowhere = triangles;
    for (glm::vec3& corner : nowhere.corners) {
        corner = glm::vec3(1e9f);
    }
    const mirror::SceneBuffers buffers(nowhere);
    const PackedStructure packed = pack(tree);
    std::vector<Ray> rays = random_rays(numbers, 300);
    for (const Ray& ray : rays_at_box_corners(numbers, tree, triangles.corners, 300)) {
        rays.push_back(ray);
    }
    std::size_t different = 0;
    std::size_t leaves = 0;
    for (const Ray& ray : rays) {
        const auto restart =
            mirror::mirror_of<mirror::walks::kd_restart<float, Trail>>(buffers, packed);
        const std::vector<int> expected = leaves_along(tree, ray);
        leaves += expected.size();
        const std::vector<int> entered = record_of(restart, tree, ray).leaves;
        // A ray that only touches the root's box comes to one leaf, for the one point.
        const bool touches = expected.empty() && entered.size() == 1;
        different += touches || entered == expected ? 0 : 1;
    }
    CHECK(different == 0);
    CHECK(leaves > 10 * rays.size());
}
