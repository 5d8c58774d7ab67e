#include "catch.h"
#include "kd_hits.h"
#include "scene/shapes.h"
#include "structure/kd_tree/kd_split.h"

#include <algorithm>

using namespace raysteps;

// What goes wrong without the rules of chapter 05, so that nobody takes them away again.
namespace {

struct NaiveWalk {
    Hit nearest;
    bool stands_still = false;
};

// The restart of many texts: after a leaf, go on from its exit plus an epsilon, with a split test
// that has no rule for equal distances.
NaiveWalk restart_with_epsilon(const KdTree& tree, const mirror::SceneBuffers& buffers,
                               const Ray& ray, float epsilon) {
    auto mirror = mirror::mirror_of<EveryTriangle>(buffers);
    const auto own = mirror::to_mirror<EveryTriangle>(ray);
    const auto prepared = mirror.prepare_ray(own);
    auto nearest = mirror.miss(own);
    float end = ray.t_max;
    float exit = ray.t_min;
    for (int axis = 0; axis < 3; ++axis) {
        const float a = (tree.boxes[0].lower[axis] - ray.origin[axis]) / ray.direction[axis];
        const float b = (tree.boxes[0].upper[axis] - ray.origin[axis]) / ray.direction[axis];
        exit = std::max(exit, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    while (exit < end) {
        const float last_exit = exit;
        const float t = last_exit + epsilon;
        exit = end;
        int place = 0;
        while (!is_leaf(tree.nodes[static_cast<std::size_t>(place)])) {
            const KdNode& node = tree.nodes[static_cast<std::size_t>(place)];
            const float split = (node.split - ray.origin[node.axis]) / ray.direction[node.axis];
            const int first = ray.direction[node.axis] > 0.0f ? 0 : 1;
            if (split < t) {
                place = node.first_child + 1 - first;
            } else {
                place = node.first_child + first;
                exit = std::min(exit, split);
            }
        }
        const KdNode& leaf = tree.nodes[static_cast<std::size_t>(place)];
        for (int i = leaf.first_reference; i < leaf.end_reference; ++i) {
            const int triangle = tree.references[static_cast<std::size_t>(i)];
            const auto hit = mirror.intersect_triangle(
                prepared, mirror.triangle_corner(triangle, 0), mirror.triangle_corner(triangle, 1),
                mirror.triangle_corner(triangle, 2), triangle);
            nearest = mirror.is_nearer(hit, nearest) ? hit : nearest;
        }
        if (mirror.is_hit(nearest) && nearest.t <= exit) {
            break;
        }
        if (exit <= last_exit) {
            return {mirror::from_mirror(nearest), true};
        }
    }
    return {mirror::from_mirror(nearest), false};
}

struct NaiveCounts {
    std::size_t standstills = 0;
    std::size_t wrong = 0;
};

NaiveCounts count_faults(const Scene& scene, std::span<const Ray> rays, float epsilon) {
    const KdTree tree = tree_for(scene, rays);
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> expected = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    NaiveCounts counts;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const NaiveWalk walk = restart_with_epsilon(tree, buffers, rays[i], epsilon);
        counts.standstills += walk.stands_still ? 1 : 0;
        counts.wrong += !walk.stands_still && walk.nearest.triangle != expected[i].triangle ? 1 : 0;
    }
    return counts;
}

Scene sphere_of_size(float scale) {
    Mesh mesh = sphere({0.0f, 0.0f, 0.0f}, 1.0f, 6);
    for (glm::vec3& corner : mesh.corners) {
        corner *= scale;
    }
    return scene_of(mesh);
}

// From around the scene at points beside it, so that they walk through many leaves; each t is
// multiplied by the factor.
std::vector<Ray> long_rays(const Scene& scene, float factor) {
    RandomNumbers numbers(61);
    std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 1000);
    for (Ray& ray : rays) {
        ray.direction /= factor;
    }
    return rays;
}

// The references that are left when a triangle is listed only where it meets the leaf's own box.
KdTree without_padding(const KdTree& tree, std::span<const glm::vec3> corners) {
    KdTree bare = tree;
    bare.references.clear();
    for (std::size_t i = 0; i < bare.nodes.size(); ++i) {
        KdNode& node = bare.nodes[i];
        const int first = node.first_reference;
        const int end = node.end_reference;
        node.first_reference = static_cast<int>(bare.references.size());
        for (int r = first; r < end; ++r) {
            const int triangle = tree.references[static_cast<std::size_t>(r)];
            const auto place = 3 * static_cast<std::size_t>(triangle);
            if (!is_empty(clipped_bounds({corners[place], corners[place + 1], corners[place + 2]},
                                         grown(tree.boxes[i], 0.0), 0.0))) {
                bare.references.push_back(triangle);
            }
        }
        node.end_reference = static_cast<int>(bare.references.size());
    }
    return bare;
}

} // namespace

TEST_CASE("an epsilon makes no progress where t is large", "[05][exhibit][hard_case]") {
    const Scene scene = sphere_of_size(1.0f);
    CHECK(count_faults(scene, long_rays(scene, 1.0f), 1e-6f).standstills == 0);
    // From 32 on, floats lie 3.8e-6 apart: 1e-6 is lost in the sum. From 2048 on, 1e-4 is.
    CHECK(count_faults(scene, long_rays(scene, 200.0f), 1e-6f).standstills > 500);
    CHECK(count_faults(scene, long_rays(scene, 20000.0f), 1e-4f).standstills > 500);
    CHECK(count_faults(scene, long_rays(scene, 1.0f), 0.0f).standstills > 500);
}

TEST_CASE("an epsilon skips hits where the scene is small", "[05][exhibit][hard_case]") {
    // Directions have the length of the scene's units, so t is as small as the scene.
    const Scene scene = sphere_of_size(1e-3f);
    std::vector<Ray> rays = long_rays(scene, 1e-3f);
    CHECK(count_faults(scene, rays, 1e-4f).wrong > 10);
    CHECK(agrees(agreement_of(scene, tree_for(scene, rays), rays)));
}

TEST_CASE("without padding rays that end at their hit miss it", "[05][exhibit][hard_case]") {
    const int seed = 62;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    // The tree is split at x = 0, and a quad begins just behind, a fraction of the spacing of
    // floats at 1. Rays from the other side aim at its edge: they reach it at t = 1, and the plane
    // there as well, but for the last bit.
    const float edge = 3e-8f;
    const Scene scene =
        scene_of(join(quad({edge, -2, 0}, {2, -2, 0.5f}, {2, 2, 0.5f}, {edge, 2, 0}),
                      quad({-2, -2, 0}, {-1, -2, 0}, {-1, 2, 0}, {-2, 2, 0})));
    KdOptions options = with_median();
    options.depth_limit = 1;
    const KdTree tree = build_kd_tree(scene.corners, options);
    CHECK(tree.nodes[0].axis == 0);
    CHECK(tree.nodes[0].split == 0.0f);
    const KdTree bare = without_padding(tree, scene.corners);
    CHECK(bare.references.size() < tree.references.size());
    const mirror::SceneBuffers buffers(scene);
    std::vector<Ray> rays;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 origin(-0.3f - numbers.unit(), 2.0f * numbers.unit(),
                               1.0f + numbers.unit());
        const glm::vec3 target(edge, 2.0f * numbers.unit() - 1.0f, 0.0f);
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    const std::vector<Hit> hits = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].t_max = hits[i].triangle == no_triangle ? rays[i].t_max : hits[i].t;
    }
    const auto different = [&](const KdTree& each) {
        const PackedStructure packed = pack(each);
        return count_different(hits, hits_by(mirror::mirror_of<Restart>(buffers, packed), rays));
    };
    CHECK(different(tree) == 0);
    CHECK(count_hits(hits) > 5000);
    CHECK(different(bare) > 100);
}
