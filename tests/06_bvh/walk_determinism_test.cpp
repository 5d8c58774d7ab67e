#include "build_trees.h"
#include "catch.h"
#include "scene/shapes.h"
#include "walk_hits.h"

#include <numeric>

using namespace raysteps;

namespace {

enum class Order { forward, backward, shuffled };

// The triangles in another order.
Mesh reordered(const Mesh& mesh, Order order) {
    std::vector<int> places(mesh.corners.size() / 3);
    std::iota(places.begin(), places.end(), 0);
    if (order == Order::backward) {
        std::reverse(places.begin(), places.end());
    }
    if (order == Order::shuffled) {
        RandomNumbers numbers(99);
        for (std::size_t i = places.size(); i > 1; --i) {
            std::swap(places[i - 1],
                      places[static_cast<std::size_t>(numbers.below(static_cast<int>(i)))]);
        }
    }
    Mesh result;
    for (const int place : places) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto i = static_cast<std::size_t>(3 * place + corner);
            result.corners.push_back(mesh.corners[i]);
            result.normals.push_back(mesh.normals[i]);
        }
    }
    return result;
}

// Each triangle once more at the end, and once more with its corners the other way round.
Mesh tripled(const Mesh& mesh) {
    Mesh turned = mesh;
    for (std::size_t i = 0; i < turned.corners.size(); i += 3) {
        std::swap(turned.corners[i + 1], turned.corners[i + 2]);
    }
    return join(join(mesh, mesh), turned);
}

} // namespace

TEST_CASE("of coincident triangles the smallest one is hit by every BVH walk in any order",
          "[06][hard_case]") {
    const int seed = 21;
    CAPTURE(seed);
    const Mesh mesh = tripled(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 3));
    BvhOptions options;
    options.leaf_triangles = 1; // copies come into leaves of their own
    for (const Order order : {Order::forward, Order::backward, Order::shuffled}) {
        RandomNumbers numbers(seed);
        const Scene scene = grey_scene(reordered(mesh, order));
        for (const RayFamily& family : ray_families(numbers, scene.corners, 400)) {
            const Agreement agreement =
                agreement_of(scene, bvh_for(scene, family.rays, options), family.rays);
            CAPTURE(static_cast<int>(order), family.name, agreement.exceptions);
            CHECK(agreement.exceptions.empty());
            CHECK(agreement.hits > 100);
        }
    }
}

TEST_CASE("of ten thousand copies of a triangle the first is hit by every BVH walk",
          "[06][hard_case]") {
    const int copies = 10000;
    Mesh mesh;
    for (int i = 0; i < copies; ++i) {
        mesh.corners.insert(mesh.corners.end(),
                            {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.5f}, {0.0f, 1.0f, 0.25f}});
    }
    mesh.normals.assign(mesh.corners.size(), {0.0f, 0.0f, 1.0f});
    const Scene scene = grey_scene(mesh);
    const std::vector<Ray> rays{{{0.25f, 0.25f, -1.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end},
                                {{0.5f, 0.25f, 3.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, no_end}};
    const mirror::SceneBuffers buffers(scene);
    for (const BvhSplit split : all_splits) {
        const mirror::BvhBuffers packed(bvh_for(scene, rays, with_split(split)), scene.corners);
        for_each_walk(buffers, packed, [&](const std::string& name, const auto& mirror) {
            for (const int rounds : {whole_walk, 100}) {
                for (const Hit& hit : hits_by(mirror, rays, rounds)) {
                    CAPTURE(name, static_cast<int>(split), rounds);
                    CHECK(hit.triangle == 0);
                }
            }
        });
    }
}
