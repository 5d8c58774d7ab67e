#include "run_comparison.h"

#include "basics/text.h"
#include "claims.h"
#include "growth.h"
#include "measure/measure_structures.h"
#include "program/output.h"

#include <fmt/core.h>

#include <iostream>

namespace raysteps {

namespace {

// All that a run found out.
struct ComparisonReport {
    std::vector<SceneCosts> results;
    std::vector<ClaimResult> claims;
    std::vector<GrowthLine> growth{};
    std::string renderer{};
    std::string embree{}; // its name; empty where it took no part
};

const BuildCosts& build_of(const SceneCosts& result, const std::string& contender) {
    static const BuildCosts unknown{};
    for (const BuildCosts& build : result.builds) {
        if (build.contender == contender) {
            return build;
        }
    }
    return unknown;
}

// For people: what each contender took to build, then one line per kind and contender. A star marks
// rates of a part of the rays.
std::string table_of(const SceneCosts& result) {
    std::string table = fmt::format("\n{}, {} triangle{}\n", result.scene, result.triangles,
                                    result.triangles == 1 ? "" : "s");
    table += "contender             build s    MB\n";
    for (const BuildCosts& build : result.builds) {
        table += fmt::format("{:21} {:7.3f} {:5.1f}\n", build.contender,
                             fact_of(build, "build_seconds"), fact_of(build, "memory_bytes") / 1e6);
    }
    table += "contender             rays             visits    tests  Mrays/s (range)          "
             "cores  other answers\n";
    bool any_sampled = false;
    for (const RayCosts& row : result.rays) {
        const bool sampled = row.rays < row.all_rays;
        any_sampled = any_sampled || sampled;
        const std::string counts =
            is_embree(row.contender)
                ? "       -        -"
                : fmt::format("{:8.1f} {:8.2f}", row.visits_per_ray, row.tests_per_ray);
        table += fmt::format("{:21} {:10} {:7}{} {}  {:<7.3g} ({:.3g} to {:.3g})  {:5.2f}  {}\n",
                             row.contender, row.kind, row.rays, sampled ? "*" : " ", counts,
                             row.rate.median, row.rate.lowest, row.rate.highest, row.cores,
                             row.different);
    }
    if (any_sampled) {
        table += "* too slow for all rays in the time there is: runs of 64, from all over.\n";
    }
    return table;
}

// For programs: a line of names, then one line per scene, contender and kind.
std::string to_csv(std::span<const SceneCosts> results) {
    std::string csv = "scene,triangles,contender,rays,count,of,visits_per_ray,tests_per_ray,"
                      "million_rays_per_second,lowest,highest,cores,build_seconds,memory_bytes,"
                      "other_answers\n";
    for (const SceneCosts& result : results) {
        for (const RayCosts& row : result.rays) {
            const BuildCosts& build = build_of(result, row.contender);
            csv +=
                csv_field(result.scene) +
                fmt::format(
                    ",{},{},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.12g},{}\n",
                    result.triangles, row.contender, row.kind, row.rays, row.all_rays,
                    row.visits_per_ray, row.tests_per_ray, row.rate.median, row.rate.lowest,
                    row.rate.highest, row.cores, fact_of(build, "build_seconds"),
                    fact_of(build, "memory_bytes"), row.different);
        }
    }
    return csv;
}

// The verdicts, each with its cases and numbers.
std::string table_of(std::span<const ClaimResult> claims) {
    std::string table;
    for (const ClaimResult& claim : claims) {
        table += "\"" + claim.claim + "\", " + claim.kind + ": " + to_words(claim.verdict) + "\n";
        for (const ClaimCase& one : claim.cases) {
            table += fmt::format("    {:16} {:15} ", one.scene, to_words(one.verdict)) +
                     one.numbers + "\n";
        }
    }
    return table;
}

Numbers row_numbers(const RayCosts& row) {
    Numbers numbers{{"contender", row.contender}, {"rays", row.rays},
                    {"of", row.all_rays},         {"million_rays_per_second", row.rate.median},
                    {"lowest", row.rate.lowest},  {"highest", row.rate.highest},
                    {"cores", row.cores},         {"other_answers", row.different}};
    if (!is_embree(row.contender)) {
        numbers["visits_per_ray"] = row.visits_per_ray;
        numbers["tests_per_ray"] = row.tests_per_ray;
    }
    return numbers;
}

// The rows of one kind, our best walk among them, and its ratio to Embree.
Numbers kind_numbers(const SceneCosts& result, const std::string& kind) {
    Numbers numbers{{"kind", kind}, {"walks", empty_list()}};
    for (const RayCosts& row : result.rays) {
        if (row.kind == kind) {
            numbers["walks"].push_back(row_numbers(row));
        }
    }
    if (const RayCosts* const best = fastest_walk(result, kind)) {
        numbers["best_walk"] = best->contender;
    }
    if (const auto ratio = ratio_to_embree(result, kind)) {
        numbers["ratio_to_embree"] = ratio->by_clock;
        numbers["ratio_by_cpu_time"] = ratio->by_cpu;
    }
    return numbers;
}

Numbers scene_numbers(const SceneCosts& result) {
    Numbers builds = empty_list();
    for (const BuildCosts& build : result.builds) {
        Numbers facts = empty_object();
        for (const Fact& fact : build.facts) {
            facts[fact.name] = fact.value;
        }
        builds.push_back({{"contender", build.contender}, {"facts", facts}});
    }
    Numbers kinds = empty_list();
    for (const std::string& kind : kinds_of(std::span(&result, 1))) {
        kinds.push_back(kind_numbers(result, kind));
    }
    return {{"scene", result.scene},
            {"triangles", result.triangles},
            {"structures", builds},
            {"rays", kinds}};
}

Numbers claim_numbers(const ClaimResult& claim) {
    Numbers cases = empty_list();
    for (const ClaimCase& one : claim.cases) {
        cases.push_back(
            {{"scene", one.scene}, {"verdict", to_words(one.verdict)}, {"numbers", one.numbers}});
    }
    return {{"claim", claim.claim},
            {"by", claim.kind},
            {"verdict", to_words(claim.verdict)},
            {"cases", cases}};
}

Numbers growth_numbers(const GrowthLine& line) {
    Numbers points = empty_list();
    for (const GrowthPoint& point : line.points) {
        points.push_back({{"triangles", point.triangles}, {"cost", point.cost}});
    }
    return {{"contender", line.contender},
            {"cost", line.cost},
            {"exponent", line.exponent},
            {"points", points}};
}

// For programs: per scene and kind of rays the rates of all contenders, our best walk, and its
// ratio to Embree by single rays where that took part; then claims and growth.
Numbers numbers_of(const ComparisonReport& report) {
    Numbers scenes = empty_list();
    for (const SceneCosts& result : report.results) {
        scenes.push_back(scene_numbers(result));
    }
    Numbers claims = empty_list();
    for (const ClaimResult& claim : report.claims) {
        claims.push_back(claim_numbers(claim));
    }
    Numbers growth = empty_list();
    for (const GrowthLine& line : report.growth) {
        growth.push_back(growth_numbers(line));
    }
    return {{"renderer", report.renderer},
            {"embree", report.embree},
            {"scenes", scenes},
            {"claims", claims},
            {"growth", growth}};
}

std::vector<std::string> scenes_of(const Comparison& comparison) {
    std::vector<std::string> scenes = comparison.scenes;
    for (int depth = 0; depth <= comparison.growth; ++depth) {
        scenes.push_back("sphereflake:" + std::to_string(depth));
    }
    return scenes;
}

std::vector<SceneCosts> measure_scenes(const PictureOptions& picture, const TraceOptions& tracing,
                                       const Comparison& comparison) {
    StructureContest contest({.structures = comparison.structures,
                              .build_values = tracing.build_values,
                              .triangle = tracing.triangle,
                              .kinds = {"primary", "shadow", "reflection", "bounce"},
                              .embree = comparison.embree_part,
                              .judge = "bvh_ordered",
                              .width = picture.size.width,
                              .height = picture.size.height,
                              .rounds = comparison.rounds,
                              .most_seconds = comparison.most_seconds},
                             measure_limits());
    std::vector<SceneCosts> results;
    for (const std::string& name : scenes_of(comparison)) {
        const Scene scene = load_scene(picture, name);
        results.push_back(contest.measure(scene, show_progress("measuring " + name)));
        std::cout << table_of(results.back()) << std::flush;
    }
    return results;
}

} // namespace

void run_comparison(const PictureOptions& picture, const TraceOptions& tracing,
                    const Comparison& comparison) {
    // Scenes are loaded one after the other, but a wrong name is found before any work.
    load_scene(picture, scenes_of(comparison).front());
    const auto context = open_context(picture);
    std::cout << (comparison.embree_part != EmbreePart::none
                      ? "Embree    " + embree_name() + ", beside ours\n"
                      : "Embree    takes no part (to have it: the package libembree-dev, and "
                        "--embree auto)\n");
    ComparisonReport report{.results = measure_scenes(picture, tracing, comparison),
                            .claims = {},
                            .renderer = renderer_name(),
                            .embree =
                                comparison.embree_part != EmbreePart::none ? embree_name() : ""};
    std::vector<ProgramLength> programs;
    for (const std::string& structure : comparison.structures) {
        programs.push_back(program_length(structure));
    }
    report.claims = judge_speed(report.results);
    report.claims.push_back(judge_simplicity(programs));
    report.growth = growth_lines(report.results, "sphereflake");
    std::cout << "\nThe paper's claims (Mrays/s of the fastest walk of each family)\n"
              << table_of(report.claims) << to_table(report.growth) << "\n";

    const Numbers numbers = numbers_of(report);
    write_text(picture.out / "compare.csv", to_csv(report.results));
    write_numbers(picture.out / "compare.json", numbers);
    write_numbers(picture.json, numbers);
    plot_growth(picture.out, report.growth);
}

} // namespace raysteps
