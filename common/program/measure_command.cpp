#include "program/measure_command.h"

#include "program/deliver.h"
#include "program/progress.h"
#include "program/tracing_options.h"

#include <iostream>

namespace raysteps {

namespace {

nlohmann::ordered_json numbers_of(const BuildCosts& build, const SceneCosts& costs) {
    nlohmann::ordered_json facts = nlohmann::ordered_json::object();
    for (const Fact& fact : build.facts) {
        facts[fact.name] = fact.value;
    }
    nlohmann::ordered_json kinds = nlohmann::ordered_json::array();
    for (const RayCosts& rays : costs.rays) {
        if (rays.contender == build.contender) {
            kinds.push_back({{"kind", rays.kind},
                             {"rays", rays.rays},
                             {"visits_per_ray", rays.visits_per_ray},
                             {"tests_per_ray", rays.tests_per_ray},
                             {"million_rays_per_second", rays.rate.median},
                             {"lowest", rays.rate.lowest},
                             {"highest", rays.rate.highest}});
        }
    }
    return {{"structure", build.contender}, {"facts", facts}, {"rays", kinds}};
}

} // namespace

void measure_and_report(const Command& command, const Scene& scene,
                        const std::vector<std::string>& structures) {
    check_build_values(command, structures);
    StructureContest contest({.structures = structures,
                              .build_values = command.build_values,
                              .triangle = command.triangle,
                              .width = command.width,
                              .height = command.height},
                             measure_limits());
    const SceneCosts costs = contest.measure(scene, show_progress("measuring"));
    nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
    for (const BuildCosts& build : costs.builds) {
        std::cout << "structure " << build.contender << ":";
        for (const Fact& fact : build.facts) {
            std::cout << " " << fact.name << " " << fact.value;
        }
        std::cout << "\n";
        numbers.push_back(numbers_of(build, costs));
    }
    std::cout << to_table(costs) << std::flush;
    deliver_numbers(command, {{"scene", command.scene},
                              {"renderer", renderer_name()},
                              {"triangle", command.triangle},
                              {"triangles", triangle_count(scene)},
                              {"structures", numbers}});
}

} // namespace raysteps
