#include "08_accuracy/judges.h"

#include "basics/random_numbers.h"
#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "reference/exact.h"
#include "scene/shapes.h"
#include "support/error_of.h"

#include <algorithm>

using namespace raysteps;

namespace {

Hit hit_of(const ReferenceHit& truth) {
    return {static_cast<float>(truth.t), static_cast<float>(truth.u), static_cast<float>(truth.v),
            truth.triangle};
}

bool share_corner(std::span<const glm::vec3> corners, int a, int b) {
    const auto of_a = corners.subspan(3 * static_cast<std::size_t>(a), 3);
    const auto of_b = corners.subspan(3 * static_cast<std::size_t>(b), 3);
    return std::find_first_of(of_a.begin(), of_a.end(), of_b.begin(), of_b.end()) != of_a.end();
}

const Hit nothing{no_end, 0.0f, 0.0f, no_triangle};

} // namespace

TEST_CASE("no fault in n cases proves less than 3 in n", "[08][faults]") {
    CHECK(fault_rate(0, 300000).counted == 0.0);
    CHECK(fault_rate(0, 300000).lowest == 0.0);
    CHECK(fault_rate(0, 300000).highest == Approx(10.0).margin(1e-9)); // 3 / 300,000
    CHECK(to_string(fault_rate(0, 16384)) == "0 (<184)");              // 183.1, rounded up
    CHECK(fault_rate(0, 0).highest == 1e6);
}

TEST_CASE("bounds of a share are those that Wilson gives", "[08][faults]") {
    // 10 of 100: (0.1 + z^2/200 -+ z sqrt(0.09/100 + z^2/40000)) / (1 + z^2/100), z = 1.96:
    // 0.0552 to 0.1744.
    const FaultRate rate = fault_rate(10, 100);
    CHECK(rate.counted == 100000.0);
    CHECK(rate.lowest == Approx(55229.0).margin(5.0));
    CHECK(rate.highest == Approx(174366.0).margin(5.0));
    CHECK(fault_rate(100, 100).highest == 1e6);
}

TEST_CASE("a unit in the last place is the step to the next float", "[08][judge]") {
    CHECK(unit_in_last_place(1.0) == 0x1p-23);
    CHECK(unit_in_last_place(-1.5) == 0x1p-23);
    CHECK(unit_in_last_place(2.0) == 0x1p-22);
    CHECK(unit_in_last_place(0.0) == 0x1p-149);
}

TEST_CASE("a hit that is gone or behind is missed and one too many is false", "[08][judge]") {
    const Mesh mesh =
        join(triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), triangle({0, 0, 1}, {4, 0, 1}, {0, 4, 1}));
    const std::vector<Ray> rays{{{1, 1, -1}, {0, 0, 1}, 0.0f, no_end},
                                {{1, 1, -1}, {0, 0, 1}, 0.0f, no_end},
                                {{1, 1, -1}, {0, 0, 1}, 0.0f, no_end},
                                {{9, 9, -1}, {0, 0, 1}, 0.0f, no_end}};
    const std::vector<ReferenceHit> truth = exact_nearest_hits(rays, mesh.corners);
    REQUIRE(truth[0].triangle == 0);
    REQUIRE(truth[3].triangle == no_triangle);
    const Hit behind{2.0f, 0.25f, 0.25f, 1};
    Hit off = hit_of(truth[0]);
    off.t = 1.0f + 0x1p-22f;
    const std::vector<Hit> hits{nothing, behind, off, behind};
    const Findings findings = judge_hits(rays, hits, truth, mesh.corners);
    CHECK(findings.faults[0].count == 2);
    CHECK(findings.faults[0].of == 4);
    CHECK(findings.faults[1].count == 1);
    REQUIRE(findings.error.has_value());
    CHECK(findings.error->largest == 2.0);
    CHECK(findings.measures.empty());
}

TEST_CASE("a neighbour is right at the edge that it shares and nowhere else", "[08][judge]") {
    // Two triangles from the edge along x: one flat, one that rises as it leaves the edge.
    const Mesh mesh =
        join(triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 4}));
    const float near = 0x1p-20f;
    const std::vector<Ray> rays{{{1, near, -1}, {0, 0, 1}, 0.0f, no_end},
                                {{1, 0.25f, -1}, {0, 0, 1}, 0.0f, no_end}};
    const std::vector<ReferenceHit> truth = exact_nearest_hits(rays, mesh.corners);
    REQUIRE(truth[0].triangle == 0);
    const std::vector<Hit> hits{{1.0f + near, 0.25f, 0.0f, 1}, {1.25f, 0.1875f, 0.0625f, 1}};
    const Findings findings = judge_hits(rays, hits, truth, mesh.corners);
    CHECK(findings.faults[0].count == 1);
    CHECK(findings.faults[1].count == 0);
    CHECK(findings.measures.empty());
    REQUIRE(findings.error.has_value());
    CHECK(findings.error->largest == 0.0); // t is the neighbour's own, to the last place
}

TEST_CASE("a ray that leaks through an edge and meets a neighbour from inside is missed",
          "[08][judge]") {
    const int seed = 1;
    CAPTURE(seed);
    const Mesh mesh = sphere({0.3f, -0.2f, 0.1f}, 1.0f, 4); // 320 triangles, closed
    std::vector<Ray> rays;
    std::vector<Hit> hits; // as if the ray had passed between the two triangles of the edge
    std::vector<ReferenceHit> truth;
    for (const RayFamily& family : families_from_inside(mesh.corners, 20000, seed)) {
        if (family.name != "edge" && family.name != "vertex") {
            continue;
        }
        const std::vector<ReferenceHit> first = exact_nearest_hits(family.rays, mesh.corners);
        std::vector<Ray> beyond = family.rays;
        for (std::size_t i = 0; i < beyond.size(); ++i) {
            beyond[i].t_min = static_cast<float>(1.001 * first[i].t);
        }
        const std::vector<ReferenceHit> second = exact_nearest_hits(beyond, mesh.corners);
        for (std::size_t i = 0; i < beyond.size(); ++i) {
            if (second[i].triangle != no_triangle && first[i].t > 0.0 &&
                share_corner(mesh.corners, first[i].triangle, second[i].triangle)) {
                rays.push_back(family.rays[i]);
                hits.push_back(hit_of(second[i]));
                truth.push_back(first[i]);
            }
        }
    }
    REQUIRE(rays.size() > 300);
    const Findings findings = judge_hits(rays, hits, truth, mesh.corners);
    const double outlines = findings.measures.empty() ? 0.0 : findings.measures[0].value;
    CHECK(findings.faults[0].count + static_cast<std::size_t>(outlines) == rays.size());
    CHECK(outlines < 0.01 * static_cast<double>(rays.size()));
    CHECK(!findings.error.has_value());
}

TEST_CASE("a miss at an outline is excused and one at an inner edge is not", "[08][judge]") {
    const Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}); // split from 0 to (1, 1)
    const std::vector<Ray> rays{{{0.5f, 0.5f, -1}, {0, 0, 1}, 0.0f, no_end},
                                {{1.0f, 0.5f, -1}, {0, 0, 1}, 0.0f, no_end}};
    const std::vector<ReferenceHit> truth = exact_nearest_hits(rays, mesh.corners);
    REQUIRE(truth[1].triangle != no_triangle);
    const Findings findings =
        judge_hits(rays, std::vector<Hit>{nothing, nothing}, truth, mesh.corners);
    CHECK(findings.faults[0].count == 1);
    REQUIRE(findings.measures.size() == 1);
    CHECK(findings.measures[0].value == 1.0);
}

TEST_CASE("a false hit beside the tip of a sliver is excused", "[08][judge]") {
    const Mesh mesh = triangle({0, 0, 0}, {1, 0.001f, 0}, {1, -0.001f, 0});
    const std::vector<Ray> rays{{{-1e-7f, 0, -1}, {0, 0, 1}, 0.0f, no_end},
                                {{-1e-3f, 0, -1}, {0, 0, 1}, 0.0f, no_end}};
    const std::vector<ReferenceHit> truth = exact_nearest_hits(rays, mesh.corners);
    const Hit found{1.0f, 0.0f, 0.0f, 0};
    const Findings findings = judge_hits(rays, std::vector<Hit>{found, found}, truth, mesh.corners);
    CHECK(findings.faults[1].count == 1); // the second is a thousandth off, beyond any rounding
    CHECK(findings.measures.at(0).value == 1.0);
}

TEST_CASE("equal pictures are alike and noise is like nothing", "[08][pictures]") {
    const int seed = 3;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    Image a(32, 32);
    Image b(32, 32);
    Image c(32, 32);
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        a.pixels[i] = glm::vec3(numbers.unit());
        b.pixels[i] = glm::vec3(numbers.unit());
        c.pixels[i] = a.pixels[i] + 0.01f * numbers.in_cube();
    }
    CHECK(structural_similarity(a, a) == Approx(1.0).margin(1e-12));
    CHECK(structural_similarity(a, b) < 0.3);
    CHECK(structural_similarity(a, c) > 0.95);
    CHECK_THAT(error_of([&] { structural_similarity(a, Image(32, 16)); }),
               contains_text("32x32 and 32x16"));
}

TEST_CASE("visible pixels are those over one step of sRGB", "[08][pictures]") {
    Image truth(8, 8);
    for (glm::vec3& pixel : truth.pixels) {
        pixel = glm::vec3(1.0f);
    }
    Image picture = truth;
    picture.at(3, 4).y = 0.9f;    // sRGB 0.95: 13 steps
    picture.at(5, 1).z = 0.9999f; // far less than a step
    const Findings findings = judge_picture(picture, truth);
    CHECK(findings.faults[0].count == 1);
    CHECK(findings.faults[0].of == 64);
    const Image marked = mark_differences(picture, truth);
    CHECK(marked.at(3, 4).x > 2.0f * marked.at(3, 4).y);
    CHECK(marked.at(5, 1).x == marked.at(5, 1).y);
}
