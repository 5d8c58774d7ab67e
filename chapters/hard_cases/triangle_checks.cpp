#include "hard_cases/aimed_rays.h"
#include "hard_cases/hard_cases.h"
#include "hard_cases/meshes.h"
#include "mirror/trace_by_mirror.h"
#include "mirror/walks.h"
#include "reference/exact.h"
#include "scene/scaling.h"
#include "structure/structure.h"
#include "tally.h"
#include "trials.h"

#include "render/rays.h"
#include "render/scene_textures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace raysteps {

namespace {

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

std::size_t count_misses(std::span<const Hit> hits) {
    return static_cast<std::size_t>(std::count_if(
        hits.begin(), hits.end(), [](const Hit& hit) { return hit.triangle == no_triangle; }));
}

// From inside a closed sphere at its edges, all lengths multiplied by 2^exponent: leaks of the loop
// over every triangle, and hits of the structures that are not the loop's.
void add_sphere(std::vector<TrialRow>& rows, const TrialTools& tools, float radius, int exponent,
                bool promised) {
    const int count = tools.rays > 0 ? tools.rays : usual_rays;
    Mesh mesh = latitude_sphere(radius, 12, 24);
    RandomNumbers numbers(tools.seed);
    std::vector<Ray> rays = edge_aimed_rays(numbers, mesh, glm::vec3(0.3f * radius), count);
    for (Ray& ray : rays) {
        ray = scaled(ray, exponent);
    }
    mesh = scaled_and_moved(std::move(mesh), std::ldexp(1.0f, exponent), glm::vec3(0.0f));
    const Scene scene = add_mesh(Scene{}, mesh, Material{});
    const std::string size = fmt::format("radius {:g}", radius) +
                             (exponent == 0 ? "" : fmt::format(" x 2^{}", exponent));
    const auto row = promised ? promised_row : reported_row;
    const auto add_rows = [&](const char* where, const auto& trace) {
        const std::vector<Hit> loop =
            trace("every_triangle", every_triangle(triangle_count(scene)));
        std::size_t unlike = 0;
        std::size_t tried = 0;
        for (const auto& [name, mirror] : mirror_walks()) {
            if (name != "every_triangle") {
                const std::vector<Hit> hits = trace(name, family_of(name).build(mesh.corners, {}));
                unlike += count_other_hits(hits, loop);
                tried += hits.size();
            }
        }
        rows.push_back(
            row(size + ", loop", where, "every ray hits", count_misses(loop), loop.size()));
        rows.push_back(row(size + ", structures", where, "the loop's bits", unlike, tried));
    };
    if (tools.by_mirror) {
        const mirror::SceneBuffers buffers(scene);
        add_rows("C++", [&](const std::string& name, const BuiltStructure& built) {
            return mirror_walks().at(name)(buffers, built.packed, rays);
        });
    }
    if (tools.gpu != nullptr) {
        const RayTextures uploaded = upload_rays(rays);
        add_rows("GPU", [&](const std::string& name, const BuiltStructure& built) {
            return tools.gpu->trace("watertight", name, upload(scene, built), uploaded,
                                    rays.size());
        });
    }
}

// A GPU may take products under 2^-126 for 0, where C++ keeps some of their digits.
std::vector<TrialRow> small_scenes(const TrialTools& tools) {
    std::vector<TrialRow> rows;
    add_sphere(rows, tools, 1e-11f, 0, true);
    for (const float radius : {1e-15f, 1e-16f, 1e-17f, 1e-18f, 3e-19f, 1e-19f, 1e-20f}) {
        add_sphere(rows, tools, radius, 0, false);
    }
    add_sphere(rows, tools, 1e-17f, greatest_scale_exponent, true);
    add_sphere(rows, tools, 1e-20f, greatest_scale_exponent, true);
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
        {"T16", "closed spheres that are too small for the digits of a float", "",
         "--scale-exponent N: all lengths times 2^N", small_scenes},
        {"T13r", "u, v, u + v and t stay in their ranges", "", "", ranges},
    };
}

} // namespace raysteps
