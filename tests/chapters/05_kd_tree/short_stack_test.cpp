#include "catch.h"
#include "hard_cases/meshes.h"
#include "kd_hits.h"
#include "scene/shapes.h"

#include <cmath>

using namespace raysteps;

TEST_CASE("a short stack that forgets finds all leaves again", "[05][hard_case]") {
    // Triangles at x = 1, 2, 4 ... 8192 and planes that halve the way to them: a ray from below
    // x = 1 puts off thirteen nodes before its first leaf, and the stack has room for eight.
    const int seed = 59;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of_corners(triangles_at_doubling_distances());
    KdOptions options = with_median();
    options.leaf_triangles = 0;
    const KdTree tree = build_kd_tree(scene.corners, options);
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(tree);
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) {
        // Past the first triangles, and through one of the last ones.
        const glm::vec3 origin(0.5f, 0.3f + numbers.unit(), 0.0625f);
        const float x = std::ldexp(1.0f, numbers.below(14));
        const glm::vec3 target(x, 0.125f * numbers.unit(), 0.0625f);
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    const KdAgreement agreement = agreement_of(scene, tree, rays);
    CAPTURE(to_text(agreement));
    CHECK(agrees(agreement));
    CHECK(agreement.hits > 1500);
    // No leaf is entered twice or skipped on the way.
    std::size_t different = 0;
    for (const Ray& ray : rays) {
        auto restart = mirror::mirror_of<mirror::walks::kd_restart<float, Trail>>(buffers, packed);
        auto stack = mirror::mirror_of<mirror::walks::kd_short_stack<float, Trail>>(buffers, packed);
        static_cast<void>(restart.closest_hit(mirror::to_mirror<decltype(restart)>(ray)));
        static_cast<void>(stack.closest_hit(mirror::to_mirror<decltype(stack)>(ray)));
        const auto no_leaf = [&](int place) {
            return !is_leaf(tree.nodes[static_cast<std::size_t>(place)]);
        };
        std::erase_if(restart.observer.visited, no_leaf);
        std::erase_if(stack.observer.visited, no_leaf);
        different += restart.observer.visited == stack.observer.visited ? 0 : 1;
    }
    CHECK(different == 0);
    // Such rays fill the stack: count the nodes that one puts off on its first way down.
    int put_off = 0;
    for (int place = 0; !is_leaf(tree.nodes[static_cast<std::size_t>(place)]);
         place = tree.nodes[static_cast<std::size_t>(place)].first_child) {
        put_off += tree.nodes[static_cast<std::size_t>(place)].axis == 0 ? 1 : 0;
    }
    CHECK(put_off > 8);
}
