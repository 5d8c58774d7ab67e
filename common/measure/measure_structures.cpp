#include "measure/measure_structures.h"

#include "basics/error.h"
#include "render/rays.h"
#include "structure/padding.h"
#include "structure/structure.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

namespace raysteps {

namespace {

std::map<std::string, std::string> own_values(const StructureFamily& family,
                                              const std::map<std::string, std::string>& values) {
    std::map<std::string, std::string> own;
    for (const BuildOption& option : family.options) {
        const auto value = values.find(option.name);
        if (value != values.end()) {
            own.insert(*value);
        }
    }
    return own;
}

} // namespace

BuiltFamilies build_families(const Scene& scene, const std::vector<std::string>& structures,
                             const std::map<std::string, std::string>& values) {
    const float reach = reach_of(scene.camera.eye, scene.corners);
    BuiltFamilies built;
    for (const std::string& structure : structures) {
        const StructureFamily family = family_of(structure);
        if (built.contains(family.name)) {
            continue;
        }
        const BuildRequest request{.reach = reach, .values = own_values(family, values)};
        built.emplace(family.name, upload(scene, family.build(scene.corners, request)));
    }
    return built;
}

const SceneTextures& built_for(const BuiltFamilies& built, const std::string& structure) {
    return built.at(family_of(structure).name);
}

namespace {

// One structure, ready to trace.
struct Contender {
    std::string structure;
    const SceneTextures& scene;
    TraceRays trace;
    TraceRays count;
};

RayCosts count_steps(Contender& contender, const RayKind& kind, const RayTextures& rays) {
    trace(contender.count, contender.scene, rays, kind.query);
    RayCosts costs{.kind = kind.name, .rays = kind.rays.size()};
    for (const glm::uvec4& texel : read_integers(*contender.count.observations())) {
        costs.visits_a_ray += texel.x;
        costs.tests_a_ray += texel.y;
    }
    costs.visits_a_ray /= static_cast<double>(kind.rays.size());
    costs.tests_a_ray /= static_cast<double>(kind.rays.size());
    return costs;
}

double seconds_to_trace(Contender& contender, const RayTextures& rays, Query query) {
    const auto start = std::chrono::steady_clock::now();
    trace(contender.trace, contender.scene, rays, query); // ends with a query: all is done then
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void summarize_rounds(RayCosts& costs, const std::vector<double>& seconds) {
    std::vector<double> rates;
    for (const double time : seconds) {
        rates.push_back(static_cast<double>(costs.rays) / time / 1e6);
    }
    costs.rate = measured_range(rates);
}

} // namespace

std::vector<StructureCosts> measure_structures(const Scene& scene, const MeasureRequest& request,
                                               const Limits& limits, const Progress& progress) {
    const BuiltFamilies built = build_families(scene, request.structures, request.build_values);
    std::vector<Contender> contenders;
    for (const std::string& structure : request.structures) {
        contenders.push_back({structure, built_for(built, structure),
                              TraceRays(walk_parts(request.triangle, structure, "none"), limits),
                              TraceRays(walk_parts(request.triangle, structure, "count"), limits)});
    }
    const RayTextures camera =
        generate_rays(scene.camera, request.width, request.height, RayGeneration::direct);
    Contender& first = contenders.front();
    const std::vector<Hit> camera_hits = read_hits(first.trace.closest_hits(camera, first.scene));
    std::vector<RayKind> kinds = ray_kinds(scene, read_rays(camera), camera_hits, 1);
    std::erase_if(kinds, [&](const RayKind& kind) {
        return std::find(request.kinds.begin(), request.kinds.end(), kind.name) ==
               request.kinds.end();
    });

    std::vector<StructureCosts> costs(contenders.size());
    const double steps = static_cast<double>(kinds.size()) * (request.rounds + 2);
    double done = 0.0;
    for (const RayKind& kind : kinds) {
        const RayTextures rays = upload_rays(kind.rays);
        std::vector<Hit> expected;
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            Contender& contender = contenders[i];
            const std::vector<Hit> hits = read_hits(
                trace(contender.trace, contender.scene, rays, kind.query), kind.rays.size());
            if (i == 0) {
                expected = hits;
            } else if (count_other_answers(hits, expected, kind.query) > 0) {
                throw Error(ExitCode::check_failed,
                            contender.structure + " and " + first.structure + " differ in " +
                                kind.name + " rays of " + scene.name +
                                ". With --triangle watertight, that is a fault of Raysteps.");
            }
            costs[i].kinds.push_back(count_steps(contender, kind, rays));
        }
        progress(++done / steps);
        std::vector<std::vector<double>> seconds(contenders.size());
        for (int round = 0; round <= request.rounds; ++round) {
            for (std::size_t i = 0; i < contenders.size(); ++i) {
                const double time = seconds_to_trace(contenders[i], rays, kind.query);
                if (round > 0) {
                    seconds[i].push_back(time);
                }
            }
            progress(++done / steps);
        }
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            summarize_rounds(costs[i].kinds.back(), seconds[i]);
        }
    }
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        costs[i].structure = contenders[i].structure;
        costs[i].facts = contenders[i].scene.structure.facts;
    }
    return costs;
}

std::string to_table(std::span<const StructureCosts> costs) {
    std::string table =
        "structure        rays        visits/ray  tests/ray  million rays/s (range)\n";
    for (const StructureCosts& structure : costs) {
        for (const RayCosts& kind : structure.kinds) {
            table +=
                fmt::format("{:16} {:10} {:11.2f} {:10.2f}  {:.3g} ({:.3g} to {:.3g})\n",
                            structure.structure, kind.kind, kind.visits_a_ray, kind.tests_a_ray,
                            kind.rate.median, kind.rate.lowest, kind.rate.highest);
        }
    }
    return table;
}

} // namespace raysteps
