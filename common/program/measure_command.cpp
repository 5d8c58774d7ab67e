#include "program/measure_command.h"

#include "program/deliver.h"
#include "program/progress.h"
#include "program/tracing_options.h"

#include <iostream>

namespace raysteps {

namespace {

nlohmann::ordered_json numbers_of(const StructureCosts& costs) {
    nlohmann::ordered_json facts = nlohmann::ordered_json::object();
    for (const Fact& fact : costs.facts) {
        facts[fact.name] = fact.value;
    }
    nlohmann::ordered_json kinds = nlohmann::ordered_json::array();
    for (const RayCosts& kind : costs.kinds) {
        kinds.push_back({{"kind", kind.kind},
                         {"rays", kind.rays},
                         {"visits_a_ray", kind.visits_a_ray},
                         {"tests_a_ray", kind.tests_a_ray},
                         {"million_rays_a_second", kind.rate.median},
                         {"lowest", kind.rate.lowest},
                         {"highest", kind.rate.highest}});
    }
    return {{"structure", costs.structure}, {"facts", facts}, {"rays", kinds}};
}

} // namespace

void measure_and_report(const Command& command, const Scene& scene,
                        const std::vector<std::string>& structures) {
    check_build_values(command, structures);
    const std::vector<StructureCosts> all =
        measure_structures(scene,
                           {.structures = structures,
                            .build_values = command.build_values,
                            .triangle = command.triangle,
                            .width = command.width,
                            .height = command.height},
                           measure_limits(), show_progress("measuring"));
    nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
    for (const StructureCosts& costs : all) {
        std::cout << "structure " << costs.structure << ":";
        for (const Fact& fact : costs.facts) {
            std::cout << " " << fact.name << " " << fact.value;
        }
        std::cout << "\n";
        numbers.push_back(numbers_of(costs));
    }
    std::cout << to_table(all) << std::flush;
    deliver_numbers(command, {{"scene", command.scene},
                              {"renderer", renderer_name()},
                              {"triangle", command.triangle},
                              {"triangles", triangle_count(scene)},
                              {"structures", numbers}});
}

} // namespace raysteps
