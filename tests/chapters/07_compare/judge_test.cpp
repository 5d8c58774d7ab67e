#include "measure/judge.h"

#include "catch.h"
#include "measure/scene_costs.h"
#include "reference/brute_force.h"
#include "scene/ray_file.h"
#include "scene/shapes.h"
#include "support/scene_of.h"
#include "support/scratch_folder.h"

#include <cmath>
#include <cstring>

using namespace raysteps;

namespace {

// Rays straight down on two triangles side by side, ten on the first and ten on the second.
Scene two_triangles_scene() {
    return scene_of(quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}));
}

RayKind rays_from_above(std::size_t count, Query query = Query::closest) {
    RayKind kind{"primary", query, {}};
    for (std::size_t i = 0; i < count; ++i) {
        const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        kind.rays.push_back({{x, 0.25f, 2.0f}, {0, 0, -1}, 0.0f, 10.0f});
    }
    return kind;
}

std::vector<Hit> true_hits(const Scene& scene, const RayKind& kind) {
    std::vector<Hit> hits;
    for (const ReferenceHit& hit : nearest_hits(kind.rays, scene.corners)) {
        hits.push_back({static_cast<float>(hit.t), static_cast<float>(hit.u),
                        static_cast<float>(hit.v), hit.triangle});
    }
    return hits;
}

Answers answers_of(const std::string& contender, const std::vector<Hit>& hits,
                   std::size_t step = 1) {
    Answers answers{contender, {}, {}};
    for (std::size_t i = 0; i < hits.size(); i += step) {
        answers.rays.push_back(i);
        answers.hits.push_back(hits[i]);
    }
    return answers;
}

// Judged by the reference in the loop's place.
Judgement judged(const Scene& scene, const RayKind& kind, const std::vector<Answers>& answers) {
    return judge(scene, kind, answers,
                 [&](const RayKind& asked) { return true_hits(scene, asked); });
}

} // namespace

TEST_CASE("walks that agree with each other and the loop leave nothing to dispute", "[07][judge]") {
    const Scene scene = two_triangles_scene();
    const RayKind kind = rays_from_above(20);
    const std::vector<Hit> hits = true_hits(scene, kind);
    const Judgement judgement =
        judged(scene, kind, {answers_of("a", hits), answers_of("b", hits, 4)});
    CHECK_FALSE(judgement.dispute.has_value());
    CHECK(judgement.judged == std::vector<std::size_t>{20, 5});
}

TEST_CASE("a bit that differs is disputed and the loop says whose it is", "[07][judge]") {
    const Scene scene = two_triangles_scene();
    const RayKind kind = rays_from_above(20);
    const std::vector<Hit> hits = true_hits(scene, kind);
    std::vector<Hit> other = hits;
    other[7].t = std::nextafter(other[7].t, 10.0f);
    const Judgement judgement =
        judged(scene, kind, {answers_of("a", other), answers_of("b", hits), answers_of("c", hits)});
    REQUIRE(judgement.dispute.has_value());
    const Dispute& dispute = *judgement.dispute;
    CHECK(dispute.disputed == 1);
    REQUIRE(dispute.disagreements.size() == 3);
    CHECK(dispute.disagreements[0].one == "a");
    CHECK(dispute.disagreements[0].other == the_loop);
    for (const Disagreement& disagreement : dispute.disagreements) {
        CHECK(disagreement.one == "a");
        CHECK(disagreement.rays == 1);
    }
    REQUIRE(dispute.rays.size() == 1);
    CHECK(dispute.rays[0].number == 7);
    CHECK(dispute.rays[0].answers.size() == 4);
    CHECK(dispute.rays[0].truth.triangle == hits[7].triangle);
    CHECK_THAT(DisputeError(dispute).what(),
               contains_text("a differs from the loop over every triangle in 1 of 20"));
}

TEST_CASE("of any hit only whether there is one is compared", "[07][judge]") {
    const Scene scene = two_triangles_scene();
    const RayKind kind = rays_from_above(20, Query::any);
    const std::vector<Hit> hits = true_hits(scene, kind);
    std::vector<Hit> other = hits;
    other[3] = {9.0f, 0.5f, 0.5f, 1 - hits[3].triangle};
    CHECK_FALSE(judged(scene, kind, {answers_of("a", other)}).dispute.has_value());
    other[3].triangle = no_triangle;
    CHECK(judged(scene, kind, {answers_of("a", other)}).dispute.has_value());
}

TEST_CASE("walks that are wrong in the same way do not pass by agreeing", "[07][judge]") {
    const Scene scene = two_triangles_scene();
    const RayKind kind = rays_from_above(2000);
    std::vector<Hit> lost = true_hits(scene, kind);
    std::size_t wrong = 0;
    for (Hit& hit : lost) { // as if the tree had lost the first triangle
        wrong += hit.triangle == 0 ? 1 : 0;
        hit.triangle = hit.triangle == 0 ? no_triangle : hit.triangle;
    }
    const Judgement judgement = judged(scene, kind, {answers_of("a", lost), answers_of("b", lost)});
    REQUIRE(judgement.dispute.has_value());
    CHECK(judgement.judged[0] == 1024);
    CHECK(judgement.dispute->disagreements.size() == 2); // both from the loop
    CHECK(judgement.dispute->disagreements[0].of == 1024);
    CHECK(judgement.dispute->disputed > wrong / 3);
}

TEST_CASE("a slow walk is compared on the rays that it was asked", "[07][judge]") {
    const Scene scene = two_triangles_scene();
    const RayKind kind = rays_from_above(20);
    const std::vector<Hit> hits = true_hits(scene, kind);
    std::vector<Hit> other = hits;
    other[8].triangle = no_triangle;
    other[9].triangle = no_triangle; // which is not asked
    const Judgement judgement =
        judged(scene, kind, {answers_of("slow", other, 4), answers_of("b", hits)});
    REQUIRE(judgement.dispute.has_value());
    CHECK(judgement.dispute->disputed == 1);
    for (const Disagreement& disagreement : judgement.dispute->disagreements) {
        CHECK(disagreement.rays == 1);
        CHECK(disagreement.of == 5);
    }
}

TEST_CASE("disputed rays come back from their file with the same bits", "[07][judge]") {
    const Scene scene = two_triangles_scene();
    RayKind kind = rays_from_above(20);
    kind.rays[5].origin.x = 0.1f + 1e-8f;
    std::vector<Hit> other = true_hits(scene, kind);
    other[5].triangle = no_triangle;
    const Judgement judgement = judged(scene, kind, {answers_of("a", other)});
    const ScratchFolder folder("07_disputed");
    const auto paths = write_dispute(folder / "new", judgement.dispute.value());
    const std::vector<Ray> rays = read_ray_file(paths[0]);
    REQUIRE(rays.size() == 1);
    CHECK(std::memcmp(&rays[0], &kind.rays[5], sizeof(Ray)) == 0);
    CHECK_THAT(bytes_of(paths[1]), contains_text("0,a,") && contains_text("0,exact arithmetic,"));
}

TEST_CASE("a sample without a fault bounds the faults by the rule of three", "[07][judge]") {
    CHECK(bound_of_wrong(1000) == 0.003);
    CHECK(bound_of_wrong(2) == 1.0);
    CHECK(bound_of_wrong(0) == 1.0);
    // The bound is where a sample of n has no fault with a probability of 5 %.
    CHECK(std::pow(1.0 - bound_of_wrong(300), 300) == Approx(0.05).epsilon(0.03));
}
