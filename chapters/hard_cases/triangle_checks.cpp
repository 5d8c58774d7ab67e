#include "hard_cases/hard_cases.h"
#include "mirror/trace_by_mirror.h"
#include "mirror/walks.h"
#include "reference/exact.h"
#include "trials.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace raysteps {

namespace {

constexpr int usual_rays = 10000;

struct Traced {
    HardScene made;
    std::vector<Hit> hits;
};

Traced trace_case(const std::string& name, const std::string& triangle, const TrialTools& tools) {
    const HardCase& hard_case = find_hard_case(name);
    const int wanted = std::min(tools.rays > 0 ? tools.rays : usual_rays, hard_case.most_rays);
    HardScene made = hard_case.make({wanted, tools.seed});
    const mirror::SceneBuffers buffers(add_mesh(Scene{}, made.mesh, Material{}));
    std::vector<Hit> hits = mirror_triangle_tests().at(triangle)(buffers, {}, made.rays);
    return {std::move(made), std::move(hits)};
}

std::vector<TrialRow> no_contraction(const TrialTools&) {
    // (1 + e)^2 = 1 + 2e + e^2, of which the type has no room for e^2: the product rounds to
    // 1 + 2e. A fused operation keeps it.
    const float e = 0x1p-12f;
    const double f = 0x1p-27;
    std::size_t fused = multiply_add(1.0f + e, 1.0f + e, -(1.0f + 2.0f * e)) == 0.0f ? 0 : 1;
    fused += multiply_add(1.0 + f, 1.0 + f, -(1.0 + 2.0 * f)) == 0.0 ? 0 : 1;
    return {promised_row("this compiler", "C++", "a * b + c is rounded twice", fused, 2)};
}

// The rays of the case come in fours that differ in the signs of their zeros.
std::vector<TrialRow> signs_of_zero(const TrialTools& tools) {
    std::vector<TrialRow> rows;
    for (const char* triangle : {"watertight", "moeller_trumbore"}) {
        const Traced traced = trace_case("T10", triangle, tools);
        std::size_t different = 0;
        for (std::size_t i = 0; i < traced.hits.size(); ++i) {
            const Hit& first = traced.hits[i - i % 4];
            different += first.triangle == traced.hits[i].triangle &&
                                 std::memcmp(&first.t, &traced.hits[i].t, sizeof first.t) == 0
                             ? 0
                             : 1;
        }
        rows.push_back(
            promised_row(triangle, "C++", "the bits of +0", different, traced.hits.size()));
    }
    return rows;
}

std::vector<TrialRow> ranges(const TrialTools& tools) {
    const Traced traced = trace_case("T13", "watertight", tools);
    std::size_t outside = 0;
    for (std::size_t i = 0; i < traced.hits.size(); ++i) {
        const Hit& hit = traced.hits[i];
        const Ray& ray = traced.made.rays[i];
        const bool in_range = hit.u >= 0.0f && hit.v >= 0.0f && hit.u + hit.v <= 1.0f &&
                              hit.t >= ray.t_min && hit.t <= ray.t_max;
        outside += hit.triangle == no_triangle || in_range ? 0 : 1;
    }
    return {
        promised_row("watertight", "C++", "u, v, u + v, t in range", outside, traced.hits.size())};
}

// How far t is from the exact one, in units in the last place: median, 99 of 100, and most.
TrialRow error_of_t(const std::string& name, const std::string& triangle, const TrialTools& tools) {
    const Traced traced = trace_case(name, triangle, tools);
    std::vector<double> errors;
    for (std::size_t i = 0; i < traced.hits.size(); ++i) {
        const Hit& hit = traced.hits[i];
        if (hit.triangle == no_triangle) {
            continue;
        }
        const std::size_t first = 3 * static_cast<std::size_t>(hit.triangle);
        const std::vector<glm::vec3>& corners = traced.made.mesh.corners;
        const ExactIntersection exact = exact_intersection(
            traced.made.rays[i], {corners[first], corners[first + 1], corners[first + 2]});
        const auto size = static_cast<float>(std::max(std::abs(exact.t), 1e-30));
        const double last_place = std::ldexp(1.0, std::ilogb(size) - 23);
        errors.push_back(std::abs(static_cast<double>(hit.t) - exact.t) / last_place);
    }
    std::sort(errors.begin(), errors.end());
    std::string words;
    if (!errors.empty()) {
        words = fmt::format("{:.2g}, {:.3g}, {:.3g}", errors[errors.size() / 2],
                            errors[errors.size() * 99 / 100], errors.back());
    }
    return {triangle, "C++", "t in ulp: 50, 99, 100 %", words, Verdict::reported, errors.size(), 0};
}

std::vector<TrialRow> errors_of_t(const std::string& name, const TrialTools& tools) {
    std::vector<TrialRow> rows;
    for (const char* triangle : {"watertight", "watertight_rounded", "moeller_trumbore"}) {
        rows.push_back(error_of_t(name, triangle, tools));
    }
    return rows;
}

} // namespace

std::vector<Trial> triangle_checks() {
    return {
        {"T3", "the compiler must not fuse a product and a sum: edges would leak", "",
         "compile with -ffp-contract=off", no_contraction},
        {"T6t", "how exact t is on slivers", "", "--triangle watertight",
         [](const TrialTools& tools) { return errors_of_t("T6", tools); }},
        {"T7t", "how exact t is where rays graze", "", "--triangle watertight",
         [](const TrialTools& tools) { return errors_of_t("T7", tools); }},
        {"T10z", "a zero's sign changes no bit", "", "", signs_of_zero},
        {"T13r", "u, v, u + v and t stay in their ranges", "", "", ranges},
    };
}

} // namespace raysteps
