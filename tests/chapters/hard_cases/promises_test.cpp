#include "catch.h"
#include "gpu/context.h"
#include "gpu/shaders.h"
#include "hard_cases/trials.h"
#include "mirror/trace_by_mirror.h"

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

} // namespace

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
