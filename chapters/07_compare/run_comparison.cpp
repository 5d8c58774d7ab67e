#include "run_comparison.h"

#include "against.h"
#include "basics/error.h"
#include "basics/text.h"
#include "claims.h"
#include "growth.h"
#include "program/figures.h"
#include "trace/measure_walks.h"

#include <fmt/core.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <optional>

namespace raysteps {

namespace {

// All that a run found out.
struct ComparisonReport {
    std::vector<SceneCosts> results;
    std::vector<SceneRecord> scenes;
    std::vector<ClaimResult> claims;
    std::vector<GrowthLine> growth{};
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
    std::size_t width = 21;
    for (const BuildCosts& build : result.builds) {
        width = std::max(width, build.contender.size());
    }
    std::string table = fmt::format("\n{}, {} triangle{}\n", result.scene, result.triangles,
                                    result.triangles == 1 ? "" : "s");
    table += fmt::format("{:{}} build s    MB\n", "contender", width);
    for (const BuildCosts& build : result.builds) {
        table += fmt::format("{:{}} {:7.3f} {:5.1f}\n", build.contender, width,
                             fact_of(build, "build_seconds"), fact_of(build, "memory_bytes") / 1e6);
    }
    table += fmt::format("{:{}} rays             visits    tests  Mrays/s (range)          cores  "
                         "other answers\n",
                         "contender", width);
    bool any_sampled = false;
    std::size_t fewest_judged = std::numeric_limits<std::size_t>::max();
    for (const RayCosts& row : result.rays) {
        const bool sampled = row.rays < row.all_rays;
        any_sampled = any_sampled || sampled;
        const std::string counts =
            is_embree(row.contender)
                ? "       -        -"
                : fmt::format("{:8.1f} {:8.2f}", row.visits_per_ray, row.tests_per_ray);
        table += fmt::format("{:{}} {:10} {:7}{} {}  {:<7.3g} ({:.3g} to {:.3g})  {:5.2f}  {}\n",
                             row.contender, width, row.kind, row.rays, sampled ? "*" : " ", counts,
                             row.rate.median, row.rate.lowest, row.rate.highest, row.cores,
                             row.different);
        if (!is_embree(row.contender)) {
            fewest_judged = std::min(fewest_judged, row.judged);
        }
    }
    if (any_sampled) {
        table += "* too slow for all rays in the time there is: runs of 64, from all over.\n";
    }
    table += fmt::format("No walk differs from another, nor from the loop over every triangle in a "
                         "random sample of {}\nor more of its rays: of each kind at most {:.2g} % "
                         "are wrong (95 % confidence).\n",
                         fewest_judged, 100.0 * bound_of_wrong(fewest_judged));
    return table;
}

// For programs: a line of names, then one line per scene, contender and kind.
std::string to_csv(std::span<const SceneCosts> results) {
    std::string csv = "scene,triangles,contender,kind,rays,all_rays,visits_per_ray,tests_per_ray,"
                      "million_rays_per_second,lowest,highest,cores,build_seconds,memory_bytes,"
                      "other_answers\n";
    for (const SceneCosts& result : results) {
        for (const RayCosts& row : result.rays) {
            const BuildCosts& build = build_of(result, row.contender);
            csv +=
                csv_field(result.scene) +
                fmt::format(
                    ",{},{},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.12g},{}\n",
                    result.triangles, csv_field(row.contender), row.kind, row.rays, row.all_rays,
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
        points.push_back(
            {{"triangles", static_cast<std::int64_t>(point.triangles)}, {"cost", point.cost}});
    }
    return {{"contender", line.contender},
            {"cost_of", line.cost},
            {"exponent", line.exponent},
            {"points", points}};
}

std::string to_word(EmbreePart part) {
    return part == EmbreePart::none ? "off" : part == EmbreePart::fast ? "fast" : "robust";
}

// For programs: what was measured in each scene; then claims and growth.
void add_findings(Numbers& figures, const ComparisonReport& report) {
    Numbers scenes = empty_list();
    for (const SceneCosts& result : report.results) {
        scenes.push_back(numbers_of(result));
    }
    Numbers claims = empty_list();
    for (const ClaimResult& claim : report.claims) {
        claims.push_back(claim_numbers(claim));
    }
    Numbers growth = empty_list();
    for (const GrowthLine& line : report.growth) {
        growth.push_back(growth_numbers(line));
    }
    figures["scenes"] = scenes;
    figures["claims"] = claims;
    figures["growth"] = growth;
}

Numbers numbers_of(const ComparisonReport& report, const PictureOptions& picture,
                   const TraceOptions& tracing, const Comparison& comparison) {
    Numbers figures{{"width", picture.size.width},
                    {"height", picture.size.height},
                    {"rounds", comparison.rounds},
                    {"triangle", tracing.triangle},
                    {"embree", comparison.embree_part != EmbreePart::none ? embree_name() : ""},
                    {"embree_mode", to_word(comparison.embree_part)}};
    add_findings(figures, report);
    return figures;
}

std::vector<std::string> names_of(const std::vector<StructureChoice>& choices) {
    std::vector<std::string> names;
    for (const StructureChoice& choice : choices) {
        names.push_back(choice.structure);
    }
    return names;
}

std::vector<std::string> scenes_of(const Comparison& comparison) {
    std::vector<std::string> scenes = comparison.scenes;
    for (int depth = 0; depth <= comparison.growth; ++depth) {
        scenes.push_back("sphereflake:" + std::to_string(depth));
    }
    return scenes;
}

// Reports what was measured, and in which scenes.
ComparisonReport measure_scenes(const PictureOptions& picture, const TraceOptions& tracing,
                                const Comparison& comparison, const EarlierRun* earlier) {
    StructureContest contest({.structures = comparison.structures,
                              .build_values = tracing.build_values,
                              .triangle = tracing.triangle,
                              .kinds = {"primary", "shadow", "reflection", "bounce"},
                              .embree = comparison.embree_part,
                              .first_walk = "bvh_ordered",
                              .width = picture.size.width,
                              .height = picture.size.height,
                              .rounds = comparison.rounds,
                              .most_seconds = comparison.most_seconds},
                             measure_limits());
    ComparisonReport report;
    for (const std::string& name : scenes_of(comparison)) {
        const Scene scene = load_scene(picture, name);
        report.scenes.push_back(record_of(scene));
        if (earlier != nullptr) {
            check_scene(*earlier, report.scenes.back());
        }
        report.results.push_back(
            measure_or_dispute(contest, scene, show_progress("measuring " + name), picture.out));
        std::cout << table_of(report.results.back()) << std::flush;
    }
    return report;
}

// The claims and the growth, of what was measured.
void conclude(ComparisonReport& report, const std::vector<std::string>& structures) {
    std::vector<ProgramLength> programs;
    for (const std::string& structure : structures) {
        programs.push_back(program_length(structure));
    }
    report.claims = judge_speed(report.results);
    report.claims.push_back(judge_simplicity(programs));
    report.growth = growth_lines(report.results, "sphereflake");
    std::cout << "\nThe paper's claims (Mrays/s of the fastest walk of each family)\n"
              << table_of(report.claims) << to_table(report.growth) << "\n";
}

// The walks that took part, each once: of `bvh_ordered:split=median` its name alone.
std::vector<std::string> walks_of(const SceneCosts& costs) {
    std::vector<std::string> walks;
    for (const BuildCosts& build : costs.builds) {
        const std::string name = build.contender.substr(0, build.contender.find(':'));
        if (!is_embree(build.contender) && std::ranges::find(walks, name) == walks.end()) {
            walks.push_back(name);
        }
    }
    return walks;
}

} // namespace

void write_comparison_jobs(const Comparison& comparison, const std::vector<std::string>& words) {
    std::vector<RunPart> jobs;
    for (const std::string& scene : scenes_of(comparison)) {
        jobs.push_back({scene, {"--scenes", scene, "--growth", "-1"}});
    }
    write_jobs(comparison.jobs, words, jobs);
}

void merge_comparison(const PictureOptions& picture, const Comparison& comparison) {
    const JobParts parts = read_parts(comparison.jobs.merge, compare_schema);
    ComparisonReport report;
    for (const Numbers& figures : parts.figures) {
        const Numbers::List& records = figures.at("head").at("scenes").values();
        const Numbers::List& scenes = figures.at("scenes").values();
        for (std::size_t i = 0; i < std::min(records.size(), scenes.size()); ++i) {
            report.results.push_back(scene_costs_of(scenes[i]));
            report.results.back().triangles = static_cast<int>(records[i].at("triangles").number());
            std::cout << table_of(report.results.back());
        }
    }
    conclude(report, report.results.empty() ? std::vector<std::string>()
                                            : walks_of(report.results.front()));
    Numbers all{{"head", head_of(parts)}};
    for (const std::string name :
         {"width", "height", "rounds", "triangle", "embree", "embree_mode"}) {
        all[name] = common_member(parts, name);
    }
    add_findings(all, report);
    write_text(picture.out / "compare.csv", to_csv(report.results));
    write_text(picture.out / "compare.json", all.to_json() + "\n");
    if (!picture.json.empty()) {
        write_text(picture.json, all.to_json() + "\n");
    }
    plot_growth(picture.out, report.growth);
    check_complete(parts);
}

void run_comparison(const PictureOptions& picture, const TraceOptions& tracing,
                    const Comparison& comparison) {
    check_build_values(tracing.build_values, names_of(comparison.structures));
    std::optional<EarlierRun> earlier;
    if (!comparison.against.empty()) {
        earlier = read_earlier_run(comparison.against);
        check_request(*earlier, picture.size, tracing.triangle, scenes_of(comparison));
    }
    // Scenes are loaded one after the other, but a wrong name is found before any work.
    load_scene(picture, scenes_of(comparison).front());
    const auto context = open_context(picture);
    std::cout << (comparison.embree_part != EmbreePart::none
                      ? "Embree    " + embree_name() + ", beside ours\n"
                      : "Embree    takes no part (to have it: the package libembree-dev, and "
                        "--embree auto)\n");
    if (earlier) { // what cannot be compared is refused before any work
        choose_yardstick(*earlier,
                         with_head({.schema = compare_schema},
                                   numbers_of(ComparisonReport{}, picture, tracing, comparison)));
    }
    ComparisonReport report =
        measure_scenes(picture, tracing, comparison, earlier ? &*earlier : nullptr);
    conclude(report, names_of(comparison.structures));

    const FiguresHead head{.schema = compare_schema,
                           .scenes = report.scenes,
                           .builders = used_builders(comparison.structures, tracing.build_values)};
    const Numbers numbers = numbers_of(report, picture, tracing, comparison);
    write_text(picture.out / "compare.csv", to_csv(report.results));
    write_figures(picture.out / "compare.json", head, numbers);
    write_figures(picture.json, head, numbers);
    plot_growth(picture.out, report.growth);
    if (!earlier) {
        return;
    }
    const AgainstReport against = report_against(*earlier, with_head(head, numbers));
    std::cout << against.text;
    if (against.slower > 0) {
        throw Error(
            ExitCode::check_failed,
            fmt::format("--against {}: {} of {} rates are lower than then beyond doubt. See "
                        "the table above, and measure again to be sure.",
                        comparison.against.string(), against.slower, against.rates));
    }
}

} // namespace raysteps
