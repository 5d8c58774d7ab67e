#include "catch.h"
#include "grid_hits.h"
#include "scene/shapes.h"
#include "support/hard_scenes.h"

using namespace raysteps;

namespace {

// All families of rays, against one scene, at one density. How many hits there are.
std::size_t check_families(int seed, const Scene& scene, double density, int count) {
    RandomNumbers numbers(seed);
    std::vector<RayFamily> families = ray_families(numbers, scene.corners, count);
    const Grid shaped = build_grid(scene.corners, with_density(density));
    for (RayFamily& family : lattice_families(numbers, lattice_of(shaped.shape), count)) {
        families.push_back(std::move(family));
    }
    std::size_t hits = 0;
    for (const RayFamily& family : families) {
        CAPTURE(seed, density, family.name);
        const Grid grid = grid_for(scene, family.rays, with_density(density));
        hits += check_agreement(scene, grid, family.rays);
    }
    return hits;
}

} // namespace

TEST_CASE("the grid finds the hits of the loop over every triangle on a closed mesh",
          "[04][agreement]") {
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 2.0f, 5));
    for (const double density : {0.5, 4.0, 32.0}) {
        CHECK(check_families(1, scene, density, 1500) > 10000); // of 16,500
    }
}

TEST_CASE("the grid finds the hits of the loop over every triangle among loose triangles",
          "[04][agreement]") {
    RandomNumbers numbers(2);
    const Scene scene = scene_of(random_triangles(numbers, 400));
    for (const double density : {0.5, 4.0, 32.0}) {
        CHECK(check_families(2, scene, density, 1500) > 10000);
    }
}

TEST_CASE("the grid finds the hits of the loop over every triangle on slivers", "[04][agreement]") {
    const int seed = 3;
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_slivers(numbers, 200));
    for (const double density : {4.0, 64.0}) {
        CHECK(check_families(seed, scene, density, 1500) > 3000);
    }
}

TEST_CASE("the grid finds the hits of the loop at every size and place", "[04][agreement]") {
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 5));
    CHECK(check_families(4, moved(scene, 1e-6f, glm::vec3(0.0f)), 4.0, 800) > 5000);
    CHECK(check_families(5, moved(scene, 1e6f, glm::vec3(0.0f)), 4.0, 800) > 5000);
    CHECK(check_families(6, moved(scene, 1.0f, glm::vec3(1e4f, -1e4f, 1e4f)), 4.0, 800) > 5000);
    CHECK(check_families(7, moved(scene, 100.0f, glm::vec3(1e6f)), 4.0, 800) > 5000);
}

TEST_CASE("the grid finds the hits of the loop on rays from far away", "[04][agreement]") {
    const int seed = 8;
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 5));
    for (const float distance : {1e2f, 1e4f, 1e6f}) {
        const std::vector<Ray> rays = rays_from_far_away(numbers, scene.corners, distance, 2000);
        CAPTURE(seed, distance);
        const Grid grid = grid_for(scene, rays);
        CHECK(check_agreement(scene, grid, rays) > 500);
    }
}

TEST_CASE("a walk cut into small rounds gives the same bits", "[04][launches]") {
    const int seed = 9;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 400));
    const std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 3000);
    const Grid grid = grid_for(scene, rays, with_density(2.0));
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> at_once = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    REQUIRE(count_hits(at_once) > 2000);
    for (const int rounds : {1, 2, 7, 100}) {
        CAPTURE(rounds);
        const PackedStructure packed = pack(grid);
        const auto walk = mirror::mirror_of<GridWalk>(buffers, packed);
        const auto mailbox = mirror::mirror_of<MailboxWalk>(buffers, packed);
        CHECK(count_different(hits_by(walk, rays, rounds), at_once) == 0);
        CHECK(count_different(hits_by(mailbox, rays, rounds), at_once) == 0);
    }
}

TEST_CASE("any hit is found exactly where there is a nearest one", "[04][agreement]") {
    const int seed = 10;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 150));
    const std::vector<Ray> rays = segments(numbers, scene.corners, 5000);
    const Grid grid = grid_for(scene, rays);
    const mirror::SceneBuffers buffers(scene);
    auto every = mirror::mirror_of<EveryTriangle>(buffers);
    const PackedStructure packed = pack(grid);
    auto walk = mirror::mirror_of<GridWalk>(buffers, packed);
    auto mailbox = mirror::mirror_of<MailboxWalk>(buffers, packed);
    std::size_t hits = 0;
    std::size_t different = 0;
    for (const Ray& ray : rays) {
        const bool hit = every.is_hit(every.closest_hit(mirror::to_mirror<EveryTriangle>(ray)));
        const auto by_walk = walk.any_hit(mirror::to_mirror<GridWalk>(ray));
        const auto by_mailbox = mailbox.any_hit(mirror::to_mirror<MailboxWalk>(ray));
        hits += hit ? 1 : 0;
        different += walk.is_hit(by_walk) != hit || mailbox.is_hit(by_mailbox) != hit ? 1 : 0;
    }
    CHECK(hits > 1000);
    CHECK(hits < 4900);
    CHECK(different == 0);
}

TEST_CASE("the walk in double finds the hits of the loop in double", "[04][agreement]") {
    const int seed = 11;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 2.0f, 5));
    const std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 2000);
    const Grid grid = grid_for(scene, rays);
    const mirror::SceneBuffers buffers(scene);
    const auto every = mirror::mirror_of<mirror::walks::every_triangle<double>>(buffers);
    const PackedStructure packed = pack(grid);
    const auto walk = mirror::mirror_of<mirror::walks::grid<double>>(buffers, packed);
    CHECK(count_different(hits_by(walk, rays), hits_by(every, rays)) == 0);
}

TEST_CASE("the mailbox tests fewer triangles and visits the same cells", "[04][mailbox]") {
    const int seed = 12;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 400));
    const std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 2000);
    const Grid grid = grid_for(scene, rays);
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(grid);
    auto walk = mirror::mirror_of<mirror::walks::grid<float, mirror::Counter>>(buffers, packed);
    auto mailbox =
        mirror::mirror_of<mirror::walks::grid_mailbox<float, mirror::Counter>>(buffers, packed);
    for (const Ray& ray : rays) {
        walk.closest_hit(mirror::to_mirror<decltype(walk)>(ray));
        mailbox.closest_hit(mirror::to_mirror<decltype(mailbox)>(ray));
    }
    CHECK(mailbox.observer.visits == walk.observer.visits);
    CHECK(mailbox.observer.tests < walk.observer.tests * 9 / 10);
    CHECK(mailbox.observer.tests > 2000);
}
