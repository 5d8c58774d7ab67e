#include "trace/measure_walks.h"

#include "measure/judge.h"
#include "trace/trace_picture.h"

#include <algorithm>
#include <iostream>

namespace raysteps {

namespace {

Numbers row_numbers(const RayCosts& row) {
    Numbers numbers{{"contender", row.contender},
                    {"rays", row.rays},
                    {"all_rays", row.all_rays},
                    {"million_rays_per_second", row.rate.median},
                    {"lowest", row.rate.lowest},
                    {"highest", row.rate.highest},
                    {"million_rays_per_cpu_second", row.cpu_rate.median},
                    {"lowest_by_cpu_time", row.cpu_rate.lowest},
                    {"highest_by_cpu_time", row.cpu_rate.highest},
                    {"busy_cores", row.cores}};
    if (is_embree(row.contender)) {
        numbers["other_answers"] = row.different;
        return numbers;
    }
    numbers["visits_per_ray"] = row.visits_per_ray;
    numbers["tests_per_ray"] = row.tests_per_ray;
    numbers["judged_rays"] = row.judged;
    numbers["bound_of_wrong"] = bound_of_wrong(row.judged);
    if (row.to_embree) {
        numbers["to_embree"] = {{"median", row.to_embree->median},
                                {"lowest", row.to_embree->lowest},
                                {"highest", row.to_embree->highest}};
    }
    return numbers;
}

Numbers kind_numbers(const SceneCosts& costs, const std::string& kind) {
    Numbers numbers{{"kind", kind}, {"walks", empty_list()}};
    for (const RayCosts& row : costs.rays) {
        if (row.kind == kind) {
            numbers["walks"].push_back(row_numbers(row));
        }
    }
    if (const RayCosts* const best = fastest_walk(costs, kind)) {
        numbers["best_walk"] = best->contender;
    }
    if (const auto ratio = ratio_to_embree(costs, kind)) {
        numbers["ratio_to_embree"] = ratio->by_clock;
        numbers["ratio_by_cpu_time"] = ratio->by_cpu;
    }
    return numbers;
}

} // namespace

SceneCosts measure_or_dispute(StructureContest& contest, const Scene& scene,
                              const Progress& progress, const std::filesystem::path& folder) {
    try {
        return contest.measure(scene, progress);
    } catch (const DisputeError& error) {
        progress(1.0);
        std::cout << to_table(error.dispute());
        for (const std::filesystem::path& path : write_dispute(folder, error.dispute())) {
            print_written(path);
        }
        throw;
    }
}

Numbers numbers_of(const SceneCosts& costs) {
    Numbers builds = empty_list();
    for (const BuildCosts& build : costs.builds) {
        builds.push_back({{"contender", build.contender}, {"facts", numbers_of(build.facts)}});
    }
    Numbers kinds = empty_list();
    std::vector<std::string> known;
    for (const RayCosts& row : costs.rays) {
        if (std::ranges::find(known, row.kind) == known.end()) {
            known.push_back(row.kind);
            kinds.push_back(kind_numbers(costs, row.kind));
        }
    }
    return {{"scene", costs.scene}, {"structures", builds}, {"kinds", kinds}};
}

namespace {

std::size_t count_at(const Numbers& row, const std::string& name) {
    const Numbers* const known = row.find(name);
    return known == nullptr ? 0 : static_cast<std::size_t>(known->number());
}

MeasuredRange range_at(const Numbers& row, const std::string& median, const std::string& lowest,
                       const std::string& highest) {
    return {row.at(median).number(), row.at(lowest).number(), row.at(highest).number()};
}

RayCosts row_of(const Numbers& row, const std::string& kind) {
    RayCosts costs{.contender = row.at("contender").text(),
                   .kind = kind,
                   .rays = count_at(row, "rays"),
                   .all_rays = count_at(row, "all_rays"),
                   .rate = range_at(row, "million_rays_per_second", "lowest", "highest"),
                   .cpu_rate = range_at(row, "million_rays_per_cpu_second", "lowest_by_cpu_time",
                                        "highest_by_cpu_time"),
                   .cores = row.at("busy_cores").number(),
                   .different = count_at(row, "other_answers"),
                   .judged = count_at(row, "judged_rays")};
    if (!is_embree(costs.contender)) {
        costs.visits_per_ray = row.at("visits_per_ray").number();
        costs.tests_per_ray = row.at("tests_per_ray").number();
    }
    if (const Numbers* const ratio = row.find("to_embree")) {
        costs.to_embree = range_at(*ratio, "median", "lowest", "highest");
    }
    return costs;
}

} // namespace

SceneCosts scene_costs_of(const Numbers& numbers) {
    SceneCosts costs{.scene = numbers.at("scene").text()};
    for (const Numbers& build : numbers.at("structures").values()) {
        BuildCosts own{build.at("contender").text(), {}};
        for (const auto& [name, value] : build.at("facts").members()) {
            own.facts.push_back({name, value.number()});
        }
        costs.builds.push_back(std::move(own));
    }
    for (const Numbers& kind : numbers.at("kinds").values()) {
        for (const Numbers& row : kind.at("walks").values()) {
            costs.rays.push_back(row_of(row, kind.at("kind").text()));
        }
    }
    return costs;
}

void measure_walks(const std::vector<std::string>& structures, const PictureOptions& picture,
                   const TraceOptions& tracing, const Scene& scene) {
    check_build_values(tracing.build_values, structures);
    const MeasureRequest request{.structures = plain_structures(structures),
                                 .build_values = tracing.build_values,
                                 .triangle = tracing.triangle,
                                 .width = picture.size.width,
                                 .height = picture.size.height};
    StructureContest contest(request, measure_limits());
    const SceneCosts costs =
        measure_or_dispute(contest, scene, show_progress("measuring"), picture.out);
    for (const BuildCosts& build : costs.builds) {
        std::cout << "structure " << build.contender << ":";
        for (const Fact& fact : build.facts) {
            std::cout << (&fact == build.facts.data() ? " " : ", ") << readable(fact);
        }
        std::cout << "\n";
    }
    std::cout << to_table(costs) << std::flush;
    write_figures(picture.json,
                  {.schema = "walks.schema.json",
                   .scenes = {record_of(scene)},
                   .builders = used_builders(request.structures, request.build_values)},
                  {{"width", picture.size.width},
                   {"height", picture.size.height},
                   {"rounds", request.rounds},
                   {"triangle", tracing.triangle},
                   {"scenes", Numbers::List{numbers_of(costs)}}});
}

} // namespace raysteps
