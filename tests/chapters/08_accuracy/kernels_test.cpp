#include "08_accuracy/judges.h"
#include "08_accuracy/trade_offs.h"
#include "catch.h"
#include "gpu/context.h"
#include "hard_cases/aimed_rays.h"
#include "mirror/walks.h"
#include "reference/exact.h"
#include "render/trace_rays.h"
#include "scene/shapes.h"
#include "support/same_bits.h"
#include "support/scene_of.h"

#include <map>

using namespace raysteps;

namespace {

constexpr std::size_t ray_count = 3000;

std::vector<Hit> hits_with(const Subject& subject, Parts parts, std::span<const Ray> rays) {
    parts["structure"] = subject.structure;
    TraceRays trace(std::move(parts), 2048);
    return read_hits(trace.closest_hits(upload_rays(rays), *subject.textures), rays.size());
}

std::size_t faults_of(const Findings& findings) {
    return findings.faults[0].count + findings.faults[1].count;
}

template <class Mirror>
std::size_t count_unlike_mirror(const Scene& scene, std::span<const Ray> rays,
                                std::span<const Hit> hits) {
    const mirror::SceneBuffers buffers(scene);
    Mirror mirror = mirror::mirror_of<Mirror>(buffers);
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit own = mirror::from_mirror(mirror.closest_hit(mirror::to_mirror<Mirror>(rays[i])));
        unlike += same_bits(own, hits[i]) ? 0 : 1;
    }
    return unlike;
}

// The methods with their faults on one family of rays at the subject.
std::map<std::string, std::size_t> faults_on(const std::shared_ptr<const Subject>& subject,
                                             const std::string& family_name, int seed) {
    const std::span<const glm::vec3> corners = subject->scene.corners;
    std::map<std::string, std::size_t> faults;
    for (const RayFamily& family : families_from_inside(corners, ray_count, seed)) {
        if (family.name == family_name) {
            const std::vector<ReferenceHit> truth = exact_nearest_hits(family.rays, corners);
            for (const TriangleMethod& method : triangle_methods()) {
                const std::vector<Hit> hits = hits_with(*subject, method.parts, family.rays);
                faults[method.name] = faults_of(judge_hits(family.rays, hits, truth, corners));
            }
        }
    }
    return faults;
}

} // namespace

TEST_CASE("every triangle test finds a triangle in the middle and misses beside it",
          "[08][triangle]") {
    const auto context = make_context(ContextKind::automatic);
    const auto subject = make_subject(scene_of(triangle({0, 0, 2}, {4, 0, 2}, {0, 4, 2})), 10.0f);
    // From below the listing's det is over 0, so even its culling lets these through.
    const std::vector<Ray> rays{{{1, 1, 6}, {0, 0, -2}, 0.0f, no_end},
                                {{3, 3, 6}, {0, 0, -2}, 0.0f, no_end},
                                {{1, 1, 6}, {0, 0, 2}, 0.0f, no_end},
                                {{1, 1, 6}, {0, 0, -2}, 0.0f, 1.5f}};
    for (const TriangleMethod& method : triangle_methods()) {
        CAPTURE(method.name);
        const std::vector<Hit> hits = hits_with(*subject, method.parts, rays);
        CHECK(hits[0].triangle == 0);
        CHECK(hits[0].t == 2.0f);
        CHECK(hits[0].u == 0.25f);
        CHECK(hits[0].v == 0.25f);
        CHECK(hits[1].triangle == no_triangle);
        CHECK(hits[2].triangle == no_triangle);
        CHECK(hits[3].triangle == no_triangle);
    }
}

TEST_CASE("new triangle tests give the same bits in GLSL and in C++", "[08][triangle]") {
    const int seed = 11;
    CAPTURE(seed);
    const auto context = make_context(ContextKind::automatic);
    const auto subject = usual_subject();
    for (const RayFamily& family : families_from_inside(subject->scene.corners, ray_count, seed)) {
        CAPTURE(family.name);
        const std::vector<Hit> pluecker =
            hits_with(*subject, {{"triangle", "triangle/pluecker.glsl"}}, family.rays);
        CHECK(count_unlike_mirror<mirror::triangle_tests::pluecker<float>>(
                  subject->scene, family.rays, pluecker) == 0);
        const std::vector<Hit> fallback =
            hits_with(*subject, {{"triangle", "triangle/watertight_fallback.glsl"}}, family.rays);
        CHECK(count_unlike_mirror<mirror::triangle_tests::watertight_fallback<float>>(
                  subject->scene, family.rays, fallback) == 0);
    }
}

TEST_CASE("at edges the watertight tests and doubles leak nothing and the others do",
          "[08][triangle]") {
    const int seed = 1;
    CAPTURE(seed);
    const auto context = make_context(ContextKind::automatic);
    std::map<std::string, std::size_t> faults = faults_on(usual_subject(), "edge", seed);
    CHECK(faults["watertight, rounded"] == 0);
    CHECK(faults["watertight, fallback"] == 0);
    CHECK(faults["watertight, exact areas"] == 0);
    CHECK(faults["watertight, double"] == 0);
    CHECK(faults["Pluecker"] == 0);
    CHECK(faults["Moeller-Trumbore"] > ray_count / 100);
    CHECK(faults["paper, repaired"] > ray_count / 100);
    CHECK(faults["Baldwin-Weber"] > ray_count / 100);
}

TEST_CASE("at vertices double leaks too and a watertight float does not", "[08][triangle]") {
    const int seed = 1;
    CAPTURE(seed);
    const auto context = make_context(ContextKind::automatic);
    std::map<std::string, std::size_t> faults = faults_on(usual_subject(), "vertex", seed);
    CHECK(faults["watertight, rounded"] == 0);
    CHECK(faults["watertight, fallback"] == 0);
    CHECK(faults["watertight, exact areas"] == 0);
    CHECK(faults["watertight, double"] == 0);
    CHECK(faults["Moeller-Trumbore, double"] > 0);
    CHECK(faults["Pluecker"] > 0);
}

TEST_CASE("on slivers only exact areas and doubles put every hit at its triangle",
          "[08][triangle]") {
    const int seed = 1;
    CAPTURE(seed);
    const auto context = make_context(ContextKind::automatic);
    std::map<std::string, std::size_t> faults = faults_on(slivers_subject(), "grazing", seed);
    CHECK(faults["watertight, exact areas"] == 0);
    CHECK(faults["watertight, double"] == 0);
    CHECK(faults["watertight, rounded"] > ray_count / 100);
    CHECK(faults["watertight, fallback"] > ray_count / 100);
    CHECK(faults["Moeller-Trumbore"] > ray_count / 100);
}

TEST_CASE("a kernel in double gives the float nearest to the true t", "[08][precision]") {
    const int seed = 5;
    CAPTURE(seed);
    const auto context = make_context(ContextKind::automatic);
    const auto subject = usual_subject();
    const std::vector<RayFamily> families =
        families_from_inside(subject->scene.corners, ray_count, seed);
    const RayFamily& family = families.at(1);
    REQUIRE(family.name == "inside");
    const std::vector<ReferenceHit> truth = exact_nearest_hits(family.rays, subject->scene.corners);
    const Parts parts{{"triangle", "triangle/watertight_rounded.glsl"},
                      {"real", "exhibit/double_precision.glsl"}};
    const Findings findings = judge_hits(family.rays, hits_with(*subject, parts, family.rays),
                                         truth, subject->scene.corners);
    CHECK(faults_of(findings) == 0);
    // Half an ulp by the last rounding; what double itself rounds is 2^-29 of that.
    CHECK(findings.error->largest <= 0.5001);
}
