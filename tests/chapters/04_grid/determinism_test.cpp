#include "catch.h"
#include "grid_hits.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"

using namespace raysteps;

TEST_CASE("of coincident triangles the smallest is hit in any order", "[04][hard_case]") {
    const int seed = 11;
    CAPTURE(seed);
    const Mesh mesh = tripled(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 3));
    for (const TriangleOrder order : all_orders) {
        RandomNumbers numbers(seed);
        CAPTURE(static_cast<int>(order));
        const Scene scene = scene_of(reordered(mesh, order));
        const std::vector<Ray> rays = rays_at_corners(numbers, scene.corners, 2000);
        CHECK(check_agreement(scene, grid_for(scene, rays), rays) > 1900);
    }
}

TEST_CASE("ten thousand copies of a triangle are one hit and the first", "[04][hard_case]") {
    std::vector<glm::vec3> corners{{4.0f, 4.0f, 4.0f}, {4.1f, 4.0f, 4.0f}, {4.0f, 4.1f, 4.0f}};
    for (int copy = 0; copy < 10000; ++copy) {
        corners.insert(corners.end(), {{0.0f, 0.0f, 0.0f}, {2.0f, 0.1f, 0.2f}, {0.1f, 2.0f, 0.3f}});
    }
    const Scene scene = scene_of_corners(corners);
    const int seed = 12;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 100);
    const Grid grid = grid_for(scene, rays, with_resolution(8));
    CHECK(check_agreement(scene, grid, rays) == 100);
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(grid);
    for (const Hit& hit : hits_by(mirror::mirror_of<MailboxWalk>(buffers, packed), rays)) {
        CHECK(hit.triangle == 1);
    }
}

TEST_CASE("a hit exactly at t_min or at t_max counts in every cell", "[04][hard_case]") {
    const int seed = 13;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 2000);
    const Grid grid = grid_for(scene, rays, with_resolution(16));
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> hits = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    std::vector<Ray> at_end = rays;
    std::vector<Ray> at_start = rays;
    std::vector<Ray> at_both = rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        at_end[i].t_max = hits[i].t;
        at_start[i].t_min = hits[i].t;
        at_both[i].t_min = hits[i].t;
        at_both[i].t_max = hits[i].t;
    }
    const std::size_t count = count_hits(hits);
    REQUIRE(count > 1500);
    CHECK(check_agreement(scene, grid, at_end) == count);
    CHECK(check_agreement(scene, grid, at_start) == count);
    CHECK(check_agreement(scene, grid, at_both) == count);
}
