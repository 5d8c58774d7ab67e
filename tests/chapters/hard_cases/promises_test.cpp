#include "catch.h"
#include "gpu/context.h"
#include "gpu/shaders.h"
#include "hard_cases/conformance.h"
#include "hard_cases/trials.h"
#include "mirror/trace_by_mirror.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <set>

using namespace raysteps;

namespace {

// Every row of every trial in that section that makes a promise keeps it.
void check_section(char section, int rays) {
    const auto context = make_context(ContextKind::automatic);
    GpuMethods gpu(measure_limits());
    const int seed = 7;
    std::size_t promises = 0;
    for (const Trial& trial : all_trials()) {
        if (trial.name[0] != section) {
            continue;
        }
        for (const TrialRow& row : trial.run({.rays = rays, .seed = seed, .gpu = &gpu})) {
            CAPTURE(trial.name, trial.title, seed, row.method, row.where, row.expected, row.got);
            CHECK(row.verdict != Verdict::fail);
            promises += row.verdict == Verdict::pass ? 1 : 0;
        }
    }
    CHECK(promises > 0);
}

// The greatest of three numbers.
double greatest(const glm::dvec3& point) {
    return std::max({point.x, point.y, point.z});
}

// How far a surface surely is from an origin, along the axis where it is farthest, in parts of the
// reach: from each triangle's plane, or from the box around it, whichever is farther.
double distance_to(std::span<const glm::vec3> corners, const glm::vec3& origin) {
    double distance = std::numeric_limits<double>::infinity();
    double reach = 0.0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const glm::dvec3 a = glm::dvec3(corners[i]) - glm::dvec3(origin);
        const glm::dvec3 b = glm::dvec3(corners[i + 1]) - glm::dvec3(origin);
        const glm::dvec3 c = glm::dvec3(corners[i + 2]) - glm::dvec3(origin);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const glm::dvec3 size = glm::abs(normal);
        const double sides = size.x + size.y + size.z;
        const double to_plane = sides > 0.0 ? std::abs(glm::dot(normal, a)) / sides : 0.0;
        const glm::dvec3 lower = glm::min(a, glm::min(b, c));
        const glm::dvec3 upper = glm::max(a, glm::max(b, c));
        const double to_box = greatest(glm::max(lower, -upper));
        distance = std::min(distance, std::max(to_plane, to_box));
        reach = std::max(reach, greatest(glm::max(-lower, upper)));
    }
    return distance / reach;
}

} // namespace

TEST_CASE("rays from inside start no nearer to a wall than is promised", "[hard_cases][T]") {
    for (const ConformanceFamily& family : conformance_families()) {
        if (family.origin != AnswerRules::Origin::inside) {
            continue;
        }
        const HardScene made = family.make({.rays = 200, .seed = 3});
        for (const Ray& ray : made.rays) {
            CAPTURE(family.name, ray.origin.x, ray.origin.y, ray.origin.z);
            CHECK(distance_to(made.mesh.corners, ray.origin) >= 0x1p-19);
        }
    }
}

TEST_CASE("doubles give the suite no other answer than exact arithmetic", "[hard_cases][exact]") {
    for (const ConformanceFamily& family : conformance_families()) {
        CAPTURE(family.name);
        const HardScene made = family.make({.rays = 30, .seed = 4});
        const AnswerRules filtered(made.mesh.corners);
        const AnswerRules exact(made.mesh.corners, Arithmetic::exact);
        for (const Ray& ray : made.rays) {
            const AllowedAnswer one = filtered.allowed(ray, family.origin);
            const AllowedAnswer other = exact.allowed(ray, family.origin);
            CHECK((one.miss == other.miss && one.anything == other.anything));
            CHECK(one.hits == other.hits);
        }
    }
}

TEST_CASE("what the paper gets wrong is right here", "[hard_cases][P]") {
    check_section('P', 1000);
}

TEST_CASE("the triangle test keeps its promises", "[hard_cases][T]") {
    check_section('T', 500);
}

TEST_CASE("the box tests keep their promises", "[hard_cases][B]") {
    check_section('B', 20000);
}

TEST_CASE("walks through grids keep their promises", "[hard_cases][G]") {
    check_section('G', 1000);
}

TEST_CASE("walks through kd-trees keep their promises", "[hard_cases][K]") {
    check_section('K', 1000);
}

TEST_CASE("builders and walks keep their promises where trees are deep", "[hard_cases][V]") {
    check_section('V', 1000);
}

TEST_CASE("the answer does not depend on the order of triangles", "[hard_cases][D]") {
    check_section('D', 1000);
}

TEST_CASE("rays that leave a surface keep their promises", "[hard_cases][S]") {
    check_section('S', 5000);
}

TEST_CASE("mirrors keep their promises", "[hard_cases][E]") {
    check_section('E', 100);
}

TEST_CASE("the loader keeps its promises", "[hard_cases][F]") {
    check_section('F', 1);
}

TEST_CASE("the platform does what walks take for granted", "[hard_cases][L]") {
    check_section('L', 1000);
}

TEST_CASE("no ray leaks at an edge or a corner through any structure", "[hard_cases][leaks]") {
    const auto context = make_context(ContextKind::automatic);
    GpuMethods gpu(measure_limits());
    const int seed = 8;
    for (const Trial& trial : leak_trials()) {
        for (const TrialRow& row : trial.run({.rays = 100000, .seed = seed, .gpu = &gpu})) {
            CAPTURE(trial.name, seed, row.method, row.where, row.expected, row.got);
            CHECK(row.wrong == 0);
            CHECK(row.tried == 100000);
        }
    }
}

TEST_CASE("no ray of ten million leaks at an edge or a corner through any structure", "[.][long]") {
    const auto context = make_context(ContextKind::automatic);
    GpuMethods gpu(measure_limits());
    for (const Trial& trial : leak_trials()) {
        for (const TrialRow& row : trial.run({.rays = 10000000, .seed = 9, .gpu = &gpu})) {
            CAPTURE(trial.name, row.method, row.where, row.got);
            CHECK(row.wrong == 0);
        }
    }
}

TEST_CASE("every structure has its mirror", "[hard_cases]") {
    for (const NamedPart& part : list_parts("structure")) {
        CAPTURE(part.name);
        CHECK(mirror_walks().count(part.name) == 1);
    }
}

TEST_CASE("trials have names of their own and titles that fit a line", "[hard_cases]") {
    std::set<std::string> names;
    for (const Trial& trial : all_trials()) {
        CAPTURE(trial.name, trial.title);
        CHECK(names.insert(trial.name).second);
        CHECK(trial.title.size() > 5);
        CHECK(trial.name.size() + 2 + trial.title.size() <= 100);
    }
    CHECK(names.size() > 80);
}
