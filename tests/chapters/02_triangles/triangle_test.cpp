#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"
#include "support/gpu_hits.h"
#include "support/mirror_hits.h"
#include "support/same_bits.h"

#include <cmath>
#include <glm/geometric.hpp>

using namespace raysteps;

namespace {

using Watertight = mirror::walks::every_triangle<float>;
using MoellerTrumbore = mirror::triangle_tests::moeller_trumbore<float>;

Scene one_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    Mesh mesh;
    mesh.corners = {a, b, c};
    mesh.normals.resize(3, {0.0f, 0.0f, 1.0f});
    return scene_of(mesh);
}

Scene unit_triangle() {
    return one_triangle({0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f});
}

// The one answer of both triangle tests; they must agree about which triangle.
Hit hit_of(const Scene& scene, const Ray& ray) {
    const std::vector<Ray> rays{ray};
    const Hit watertight = mirror_hits<Watertight>(scene, rays).front();
    const Hit moeller_trumbore = mirror_hits<MoellerTrumbore>(scene, rays).front();
    CHECK(watertight.triangle == moeller_trumbore.triangle);
    return watertight;
}

Ray down(float x, float y) {
    return {{x, y, 2.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, no_end};
}

} // namespace

TEST_CASE("a hit has the distance and the weights of the corners b and c", "[02][triangle]") {
    const Hit hit = hit_of(unit_triangle(), down(0.25f, 0.5f));
    CHECK(hit.triangle == 0);
    CHECK(hit.t == 2.0f);
    CHECK(hit.u == 0.25f);
    CHECK(hit.v == 0.5f);
}

TEST_CASE("t counts lengths of the direction", "[02][triangle]") {
    const Ray ray{{0.25f, 0.25f, 2.0f}, {0.0f, 0.0f, -4.0f}, 0.0f, no_end};
    CHECK(hit_of(unit_triangle(), ray).t == 0.5f);
}

TEST_CASE("edges and corners belong to the triangle and both sides can be hit", "[02][triangle]") {
    const Scene scene = unit_triangle();
    for (const auto& [x, y] : {std::pair{0.0f, 0.0f},
                               {1.0f, 0.0f},
                               {0.0f, 1.0f},
                               {0.5f, 0.0f},
                               {0.0f, 0.5f},
                               {0.5f, 0.5f}}) {
        CAPTURE(x, y);
        CHECK(hit_of(scene, down(x, y)).triangle == 0);
        CHECK(hit_of(scene, {{x, y, -2.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end}).triangle == 0);
    }
    CHECK(hit_of(scene, down(0.5000001f, 0.5f)).triangle == no_triangle);
    CHECK(hit_of(scene, down(-1e-7f, 0.5f)).triangle == no_triangle);
}

TEST_CASE("a hit lies between t_min and t_max and both belong to the ray", "[02][triangle]") {
    const Scene scene = unit_triangle();
    const auto with_range = [&](float t_min, float t_max) {
        return hit_of(scene, {{0.25f, 0.25f, 2.0f}, {0.0f, 0.0f, -1.0f}, t_min, t_max}).triangle;
    };
    CHECK(with_range(2.0f, 2.0f) == 0);
    CHECK(with_range(0.0f, 1.9999999f) == no_triangle);
    CHECK(with_range(2.0000002f, no_end) == no_triangle);
    CHECK(with_range(3.0f, 1.0f) == no_triangle);
    CHECK(with_range(0.0f, std::numeric_limits<float>::infinity()) == 0);
}

TEST_CASE("a ray without a direction is empty and hits nothing", "[02][triangle]") {
    const Scene scene = scene_of(join(triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}),
                                      triangle({0, 0, 0}, {0, 0, 1}, {1, 0, 1})));
    const auto context = make_context(ContextKind::automatic);
    TraceRays trace({{"triangle", "triangle/watertight.glsl"}}, 1);
    const SceneTextures textures = upload(scene);
    Watertight mirror{};
    for (const glm::vec3& direction : {glm::vec3(0.0f), glm::vec3(-0.0f), {0.0f, -0.0f, 0.0f}}) {
        for (const float t_min : {0.0f, -no_end}) {
            // The origin lies in both triangles.
            const std::vector<Ray> rays{{{0.0f, 0.0f, 0.0f}, direction, t_min, no_end}};
            CHECK(mirror.is_empty(mirror::to_mirror<Watertight>(rays.front())));
            CHECK(hit_of(scene, rays.front()).triangle == no_triangle);
            const Texture hits = trace.closest_hits(upload_rays(rays), textures);
            CHECK(read_hits(hits, 1).front().triangle == no_triangle);
            // A launch is one triangle here: two would be for a walk that is begun at all.
            CHECK(trace.launch_count() == 1);
        }
    }
    const std::vector<Ray> ray{{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1e-30f}, -no_end, no_end}};
    CHECK_FALSE(mirror.is_empty(mirror::to_mirror<Watertight>(ray.front())));
    CHECK(read_hits(trace.closest_hits(upload_rays(ray), textures), 1).front().triangle == 0);
    CHECK(trace.launch_count() == 2);
}

TEST_CASE("of equal distances the smallest triangle wins on the GPU and in the mirror",
          "[02][triangle]") {
    Mesh mesh;
    for (int copy = 0; copy < 3000; ++copy) {
        // Copies in every winding, behind one that lies farther away.
        const float z = copy == 0 ? -1.0f : 0.0f;
        const glm::vec3 a(0.0f, 0.0f, z);
        const glm::vec3 b(1.0f, 0.0f, z);
        const glm::vec3 c(0.0f, 1.0f, z);
        mesh.corners.insert(mesh.corners.end(), {a, copy % 2 == 0 ? b : c, copy % 2 == 0 ? c : b});
    }
    mesh.normals.resize(mesh.corners.size(), {0.0f, 0.0f, 1.0f});
    const Scene scene = scene_of(mesh);
    CHECK(hit_of(scene, down(0.25f, 0.25f)).triangle == 1);
    const auto context = make_context(ContextKind::automatic);
    for (const int rounds_per_launch : {1000, 2048}) {
        CHECK(gpu_hits(scene, std::vector<Ray>{down(0.25f, 0.25f)}, "watertight", rounds_per_launch)
                  .front()
                  .triangle == 1);
    }
}

TEST_CASE("the quad of hard case T4 is hit", "[02][hard_case]") {
    Mesh mesh;
    mesh.corners = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
    mesh.normals.resize(6, {0.0f, 0.0f, 1.0f});
    const Ray ray{{0.0f, 0.0f, 10.0f}, {0.30458447f, 0.30458447f, -0.9024725f}, 0.0f, no_end};
    CHECK(mirror_hits<Watertight>(scene_of(mesh), std::vector<Ray>{ray}).front().triangle !=
          no_triangle);
}

TEST_CASE("tiny triangles are hit down to edges of 1e-18", "[02][hard_case]") {
    // Below about 1e-19 a product of two edges is under the smallest float, and everything is a
    // miss.
    for (float s = 1.0f; s > 0.9e-18f; s *= 0.1f) {
        CAPTURE(s);
        const Scene scene = one_triangle({0.0f, 0.0f, 0.0f}, {s, 0.0f, 0.0f}, {0.0f, s, 0.0f});
        const Ray ray{{s / 3.0f, s / 3.0f, -1.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end};
        CHECK(hit_of(scene, ray).triangle == 0);
    }
}

TEST_CASE("a triangle without an area is never hit and gives no NaN", "[02][hard_case]") {
    const glm::vec3 a(0.25f, 0.25f, 0.0f);
    const glm::vec3 b(0.5f, 0.5f, 0.0f);
    for (const Scene& scene : {one_triangle(a, a, a), one_triangle(a, a, b), one_triangle(a, b, b),
                               one_triangle(a, b, a), one_triangle(a, b, {0.75f, 0.75f, 0.0f})}) {
        for (const auto& [x, y] : {std::pair{0.25f, 0.25f}, {0.375f, 0.375f}, {0.5f, 0.5f}}) {
            const Hit hit = hit_of(scene, down(x, y));
            CHECK(hit.triangle == no_triangle);
            CHECK(hit.t == no_end);
        }
    }
}

TEST_CASE("a ray in the plane of the triangle misses by definition", "[02][hard_case]") {
    const Ray ray{{-1.0f, 0.25f, 0.0f}, {1.0f, 0.0f, 0.0f}, 0.0f, no_end};
    CHECK(hit_of(unit_triangle(), ray).triangle == no_triangle);
}

TEST_CASE("a zero's sign changes no bit", "[02][hard_case]") {
    const Scene scene = unit_triangle();
    const std::vector<Ray> rays{{{0.25f, 0.25f, 2.0f}, {+0.0f, +0.0f, -1.0f}, 0.0f, no_end},
                                {{0.25f, 0.25f, 2.0f}, {-0.0f, +0.0f, -1.0f}, 0.0f, no_end},
                                {{0.25f, 0.25f, 2.0f}, {-0.0f, -0.0f, -1.0f}, -0.0f, no_end}};
    const std::vector<Hit> hits = mirror_hits<Watertight>(scene, rays);
    CHECK(same_bits(hits[0], hits[1]));
    CHECK(same_bits(hits[0], hits[2]));
}

TEST_CASE("u and v and their sum stay between 0 and 1", "[02][triangle]") {
    const int seed = 6;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 300));
    const std::vector<Ray> rays = random_rays(numbers, 30000);
    for (const Hit& hit : mirror_hits<Watertight>(scene, rays)) {
        if (hit.triangle != no_triangle) {
            const bool in_range =
                hit.u >= 0.0f && hit.v >= 0.0f && hit.u + hit.v <= 1.0f && hit.t >= 0.0f;
            CAPTURE(hit.u, hit.v, hit.t);
            REQUIRE(in_range);
        }
    }
}
