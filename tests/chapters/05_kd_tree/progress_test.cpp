#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "kd_hits.h"
#include "scene/shapes.h"

using namespace raysteps;

namespace {

// How often a walk that is cut as short as can be does not come farther: t must grow, or the next
// reference of the same leaf, or the node that is entered.
template <class Mirror>
std::size_t count_standstills(Mirror mirror, std::span<const Ray> rays) {
    std::size_t standstills = 0;
    for (const Ray& ray : rays) {
        const auto own = mirror::to_mirror<Mirror>(ray);
        auto walk = mirror.start_walk(own);
        while (!walk.ended && standstills == 0) {
            const auto before = walk;
            walk = mirror.go_on(walk, own, -mirror.farthest, 1);
            const float t_before = mirror.reached(before);
            const float t = mirror.reached(walk);
            const bool next_reference = t == t_before && walk.place.z > before.place.z;
            const bool next_node = t == t_before && walk.place.y != before.place.y;
            standstills += walk.ended || t > t_before || next_reference || next_node ? 0 : 1;
        }
    }
    return standstills;
}

} // namespace

TEST_CASE("K1 every walk makes progress at every step", "[05][hard_case]") {
    const int seed = 51;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 4));
    const KdTree tree = build_kd_tree(scene.corners, with_small_leaves());
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(tree);
    for (const RayFamily& family : tree_families(numbers, tree, scene.corners, 300)) {
        for (const float distance : {1.0f, 1e5f}) {
            const std::vector<Ray> rays = with_large_t(family.rays, distance);
            CAPTURE(family.name, distance);
            CHECK(count_standstills(mirror::mirror_of<Restart>(buffers, packed), rays) == 0);
            CHECK(count_standstills(mirror::mirror_of<Backtrack>(buffers, packed), rays) == 0);
            CHECK(count_standstills(mirror::mirror_of<ShortStack>(buffers, packed), rays) == 0);
            CHECK(count_standstills(mirror::mirror_of<RopesWalk>(buffers, packed), rays) == 0);
        }
    }
}
