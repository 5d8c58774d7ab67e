#include "trace/measure_walks.h"

#include "measure/measure_structures.h"
#include "program/output.h"

#include <iostream>

namespace raysteps {

namespace {

Numbers numbers_of(const BuildCosts& build, const SceneCosts& costs) {
    Numbers facts = empty_object();
    for (const Fact& fact : build.facts) {
        facts[fact.name] = fact.value;
    }
    Numbers kinds = empty_list();
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

void measure_walks(const std::vector<std::string>& structures, const PictureOptions& picture,
                   const TraceOptions& tracing, const Scene& scene) {
    check_build_values(tracing.build_values, structures);
    StructureContest contest({.structures = structures,
                              .build_values = tracing.build_values,
                              .triangle = tracing.triangle,
                              .width = picture.size.width,
                              .height = picture.size.height},
                             measure_limits());
    const SceneCosts costs = contest.measure(scene, show_progress("measuring"));
    Numbers numbers = empty_list();
    for (const BuildCosts& build : costs.builds) {
        std::cout << "structure " << build.contender << ":";
        for (const Fact& fact : build.facts) {
            std::cout << (&fact == build.facts.data() ? " " : ", ") << readable(fact);
        }
        std::cout << "\n";
        numbers.push_back(numbers_of(build, costs));
    }
    std::cout << to_table(costs) << std::flush;
    write_numbers(picture.json, {{"scene", picture.scene},
                                 {"renderer", renderer_name()},
                                 {"triangle", tracing.triangle},
                                 {"triangles", triangle_count(scene)},
                                 {"structures", numbers}});
}

} // namespace raysteps
