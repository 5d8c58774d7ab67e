#include "catch.h"
#include "hard_cases/meshes.h"
#include "hard_cases/aimed_rays.h"
#include "kd_hits.h"
#include "scene/shapes.h"
#include "structure/kd_tree/check_kd_tree.h"
#include "support/hard_scenes.h"

#include <algorithm>

using namespace raysteps;

TEST_CASE("K2 no walk depends on the size of t", "[05][hard_case]") {
    const int seed = 52;
    CAPTURE(seed);
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        RandomNumbers numbers(seed);
        const Mesh ball = sphere({0.0f, 0.0f, 0.0f}, 1.0f, 4);
        const Scene scene = moved(scene_of(ball), scale, glm::vec3(0.0f));
        for (const float distance : {1e-4f, 32.0f, 2048.0f, 1e7f}) {
            const std::vector<Ray> rays =
                with_large_t(rays_at_edges(numbers, scene.corners, 500), distance);
            const KdAgreement agreement = agreement_of(scene, tree_for(scene, rays), rays);
            CAPTURE(scale, distance, to_text(agreement));
            CHECK(agrees(agreement));
            CHECK(agreement.hits > 400);
        }
    }
}

TEST_CASE("K3 rays in the planes of splits are answered", "[05][hard_case]") {
    const int seed = 53;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 300));
    const KdTree tree = build_kd_tree(scene.corners, with_small_leaves());
    const std::vector<Ray> in_one = rays_in_box_planes(numbers, tree, scene.corners, 3000);
    const std::vector<Ray> in_two = rays_along_box_edges(numbers, tree, 3000);
    for (const std::vector<Ray>& rays : {in_one, in_two}) {
        const KdAgreement agreement = agreement_of(scene, tree, rays);
        CAPTURE(to_text(agreement));
        CHECK(agrees(agreement));
        CHECK(agreement.hits > 1000);
    }
}

TEST_CASE("K4 triangles that lie in planes of splits are hit", "[05][hard_case]") {
    const int seed = 54;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(walls_at_whole_coordinates());
    for (const KdOptions& options : {KdOptions{}, with_median(), with_small_leaves()}) {
        const KdTree tree = build_kd_tree(scene.corners, options);
        CHECK(check_kd_tree(tree, scene.corners).empty());
        std::vector<RayFamily> families = ray_families(numbers, scene.corners, 500);
        const Lattice lattice{glm::vec3(0.0f), glm::vec3(1.0f), glm::ivec3(4)};
        families.push_back({"lattice", rays_through_lattice_points(numbers, lattice, 1000)});
        families.push_back({"planes", rays_in_lattice_planes(numbers, lattice, 1000)});
        for (const RayFamily& family : families) {
            const KdAgreement agreement = agreement_of(scene, tree, family.rays);
            CAPTURE(family.name, to_text(agreement));
            CHECK(agrees(agreement));
        }
    }
}

TEST_CASE("K5 no split equals a bound and the builder ends", "[05][hard_case]") {
    // A box around its own faces, split as often as can be: each plane that lies in a face of the
    // box is a bound of some node.
    const std::vector<glm::vec3> corners = box_in_the_corner_of_a_box();
    KdOptions options = with_small_leaves();
    options.depth_limit = 64;
    options.bad_splits = 16;
    for (const KdSplit split : {KdSplit::area, KdSplit::median}) {
        options.split = split;
        options.depth_limit = split == KdSplit::area ? 64 : 12;
        const KdTree tree = build_kd_tree(corners, options);
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            const KdNode& node = tree.nodes[i];
            const bool inside = is_leaf(node) || (node.split > tree.boxes[i].lower[node.axis] &&
                                                  node.split < tree.boxes[i].upper[node.axis]);
            CHECK(inside);
        }
        CHECK(check_kd_tree(tree, corners).empty());
    }
}

TEST_CASE("K6 walks go on through edges and corners of leaves", "[05][hard_case]") {
    const int seed = 56;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    // Medians of a cube: planes at fractions of its side, and rays along its diagonals that meet
    // two or three of them at equal distances, again and again.
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 5));
    KdOptions options = with_median();
    options.leaf_triangles = 0;
    const KdTree tree = build_kd_tree(scene.corners, options);
    std::vector<Ray> rays;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 through = any_box_corner(numbers, tree);
        glm::vec3 direction;
        for (int axis = 0; axis < 3; ++axis) {
            direction[axis] = static_cast<float>(numbers.below(3) - 1);
        }
        rays.push_back({through - 4.0f * direction, direction, -no_end, no_end});
    }
    for (const int rounds : {1 << 30, 1}) {
        const KdAgreement agreement = agreement_of(scene, tree, rays, rounds);
        CAPTURE(to_text(agreement));
        CHECK(agrees(agreement));
        CHECK(agreement.hits > 1000);
    }
    // The rays are worth their name: ropes lead many of them to leaves that they only touch.
    const mirror::SceneBuffers buffers(scene);
    const PackedStructure packed = pack(tree);
    std::size_t by_ropes = 0;
    std::size_t by_restart = 0;
    const auto leaves_of = [&](auto mirror, const Ray& ray) {
        static_cast<void>(mirror.closest_hit(mirror::to_mirror<decltype(mirror)>(ray)));
        return std::count_if(mirror.observer.visited.begin(), mirror.observer.visited.end(), [&](int place) {
            return is_leaf(tree.nodes[static_cast<std::size_t>(place)]);
        });
    };
    for (const Ray& ray : rays) {
        by_ropes += static_cast<std::size_t>(
            leaves_of(mirror::mirror_of<mirror::walks::kd_ropes<float, Trail>>(buffers, packed), ray));
        by_restart += static_cast<std::size_t>(
            leaves_of(mirror::mirror_of<mirror::walks::kd_restart<float, Trail>>(buffers, packed), ray));
    }
    CAPTURE(by_ropes, by_restart);
    CHECK(by_ropes > by_restart + 100);
}

TEST_CASE("K7 a ray that is one point long is answered", "[05][hard_case]") {
    const int seed = 57;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 5));
    const KdTree tree = build_kd_tree(scene.corners, with_small_leaves());
    const mirror::SceneBuffers buffers(scene);
    std::vector<Ray> points;
    std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 2000);
    for (const Ray& ray : rays_at_box_corners(numbers, tree, scene.corners, 2000)) {
        rays.push_back(ray);
    }
    const std::vector<Hit> hits = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Ray point = rays[i];
        // Where the hit is, or at the corner of the box.
        point.t_min = hits[i].triangle == no_triangle ? 1.0f : hits[i].t;
        point.t_max = point.t_min;
        points.push_back(point);
    }
    const KdAgreement agreement = agreement_of(scene, tree, points);
    CAPTURE(to_text(agreement));
    CHECK(agrees(agreement));
    CHECK(agreement.hits > 1500);
}

TEST_CASE("K8 a hit beyond the exit of its leaf does not end the walk", "[05][hard_case]") {
    // A long triangle reaches through all leaves; a small one before its far end lies in a later
    // leaf and is nearer. A walk that took the first hit of the first leaf would take the long one.
    RandomNumbers numbers(58);
    const auto [mesh, small] = long_triangle_before_a_small_one_among_clutter(numbers);
    const Scene scene = scene_of(mesh);
    const KdTree tree = build_kd_tree(scene.corners, with_small_leaves());
    const glm::vec3 origin(-1.0f, 1.0f, 0.5f);
    std::vector<Ray> rays;
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 target = small + glm::vec3(0.05f, 0.05f, 0.0f) * numbers.in_cube();
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    const KdAgreement agreement = agreement_of(scene, tree, rays);
    CAPTURE(to_text(agreement));
    CHECK(agreement.hits > 100);
    CHECK(agrees(agreement));
}
