#include "catch.h"
#include "check/answers.h"
#include "files.h"
#include "mirror/trace_by_mirror.h"
#include "scene/ray_file.h"
#include "scene/shapes.h"
#include "support/error_of.h"
#include "support/same_bits.h"
#include "support/scratch_folder.h"

using namespace raysteps;

namespace {

std::vector<Ray> some_rays() {
    const int seed = 4;
    RandomNumbers numbers(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 origin = 5.0f * any_direction(numbers);
        rays.push_back({origin, numbers.in_cube() - origin, 0.0f, 1e30f});
    }
    return rays;
}

std::vector<Hit> right_hits(std::span<const Ray> rays) {
    return mirror_triangle_tests().at("watertight")(mirror::SceneBuffers(ball()), {}, rays);
}

// What is said of hits of which the first, on a ray at the ball's middle, was changed.
template <class Change>
std::string cause_after(const Change& change) {
    const std::vector<Ray> rays{{{0.3f, 0.2f, 5.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, 1e30f}};
    std::vector<Hit> hits = right_hits(rays);
    REQUIRE(hits[0].triangle >= 0);
    change(hits[0]);
    const AnswerCheck check = check_hits(hits, ball(), rays);
    return check.wrong.empty() ? "" : check.wrong.front().cause;
}

} // namespace

TEST_CASE("hits of another engine are right within rounding", "[check][hits]") {
    const std::vector<Ray> rays = some_rays();
    std::vector<Hit> hits = right_hits(rays);
    CHECK(check_hits(hits, ball(), rays).wrong.empty());
    for (Hit& hit : hits) {
        hit.t *= 1.0f + 0x1p-22f;
    }
    CHECK(check_hits(hits, ball(), rays).wrong.empty());
}

TEST_CASE("each wrong hit of another engine is told, and why", "[check][hits]") {
    const std::vector<Ray> rays{{{0.3f, 0.2f, 5.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, 1e30f}};
    const int right = right_hits(rays)[0].triangle;
    const std::string name = "triangle " + std::to_string(right);
    CHECK(cause_after([](Hit&) {}).empty());
    CHECK(cause_after([](Hit& hit) { hit.triangle = no_triangle; }) == name + " is missed");
    CHECK(cause_after([](Hit& hit) { hit.triangle = 5000; }) == "the scene has no such triangle");
    CHECK(cause_after([](Hit& hit) { hit.triangle = (hit.triangle + 700) % 1520; }) ==
          "the ray does not meet triangle " + std::to_string((right + 700) % 1520));
    const std::string distance = "the ray meets " + name + " at ";
    CHECK_THAT(cause_after([](Hit& hit) { hit.t += 0.01f; }), contains_text(distance));
    CHECK_THAT(cause_after([](Hit& hit) { hit.t = std::nanf(""); }), contains_text(distance));
    std::vector<Ray> behind = rays;
    behind[0].t_min = 5.0f;
    CHECK(check_hits(right_hits(behind), ball(), rays).wrong.front().cause == name + " is nearer");
}

TEST_CASE("a miss at an edge is wrong where the edge is closed, and right at a border",
          "[check][hits]") {
    const std::vector<Ray> rays{{{0.5f, 0.5f, 1.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, 1e30f},
                                {{1.0f, 0.25f, 1.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, 1e30f}};
    const Mesh square = quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    const Scene scene = add_mesh(Scene{}, square, Material{});
    const Hit missed{1e30f, 0.0f, 0.0f, no_triangle};
    const AnswerCheck check = check_hits(std::vector{missed, missed}, scene, rays);
    REQUIRE(check.wrong.size() == 1);
    CHECK(check.wrong.front().ray == 0);
    CHECK(check.wrong.front().cause ==
          "triangle " + std::to_string(check.wrong.front().right.triangle) + " is missed");
}

TEST_CASE("a file of hits comes back with the same bits", "[check][hits]") {
    const std::vector<Hit> hits = right_hits(some_rays());
    const ScratchFolder folder("hit_files");
    for (const std::string name : {"hits.csv", "hits.f32"}) {
        write_hit_file(folder / name, hits);
        const std::vector<Hit> again = read_hit_file(folder / name);
        REQUIRE(again.size() == hits.size());
        for (std::size_t i = 0; i < hits.size(); ++i) {
            CHECK(same_bits(again[i], hits[i]));
        }
    }
    put_bytes(folder / "odd.f32", "12345");
    CHECK_THAT(error_of([&] { read_hit_file(folder / "odd.f32"); }), contains_text("a hit has 16"));
    put_bytes(folder / "odd.csv", "t,u,v,triangle\n1,2,3\n");
    CHECK_THAT(error_of([&] { read_hit_file(folder / "odd.csv"); }), contains_text("odd.csv:2"));
    CHECK_THAT(error_of([&] { check_hits({}, ball(), some_rays()); }), contains_text("0 hits for"));
}
