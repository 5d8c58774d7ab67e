#include "trade_offs.h"

#include "gpu/shaders.h"
#include "hard_cases/aimed_rays.h"
#include "render/rays.h"
#include "render/trace_rays.h"
#include "scene/view.h"
#include "structure/padding.h"

#include <cstring>
#include <map>

namespace raysteps {

namespace {

struct SpeedMethod {
    std::string name;
    std::string structure;
    std::map<std::string, std::string> values;
};

const std::vector<SpeedMethod>& speed_methods() {
    static const std::vector<SpeedMethod> all{
        {"BVH, 4 bins", "fastest", {{"bins", "4"}}},
        {"BVH, 32 bins", "fastest", {}},
        {"BVH, 128 bins", "fastest", {{"bins", "128"}}},
        {"BVH, leaves of 1", "fastest", {{"leaf-triangles", "1"}}},
        {"BVH, leaves of 16", "fastest", {{"leaf-triangles", "16"}}},
        {"skip BVH, float boxes", "bvh_skip", {}},
        {"skip BVH, room in the test", "bvh_skip_padded", {}},
        {"skip BVH, half boxes", "half_bvh", {}},
        {"grid, 32 cells", "grid", {{"resolution", "32"}}},
        {"grid, 96 cells", "grid", {{"resolution", "96"}}}};
    return all;
}

struct SpeedFamily {
    std::string name;
    RayTextures rays;
    std::size_t count = 0;
    std::vector<Hit> expected{};
};

Findings compare(std::span<const Hit> hits, const SpeedFamily& family, const SceneTextures& scene) {
    Fault other{"other answers", 0, family.count};
    for (std::size_t i = 0; i < family.count; ++i) {
        other.count += std::memcmp(&hits[i], &family.expected[i], sizeof(Hit)) == 0 ? 0 : 1;
    }
    Findings findings{{other}, std::nullopt, {}};
    for (const Fact& fact : scene.structure.facts) {
        if (fact.name == "memory_bytes") {
            findings.measures.push_back({"megabytes", fact.value * 1e-6});
        }
    }
    return findings;
}

std::vector<std::shared_ptr<SpeedFamily>> families_of(const Scene& scene, const Effort& effort) {
    const int size = effort.picture_size;
    const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    std::vector<std::shared_ptr<SpeedFamily>> families;
    families.push_back(std::make_shared<SpeedFamily>(SpeedFamily{
        "camera", generate_rays(scene.camera, size, size, RayGeneration::direct), pixels}));
    if (scene.corners.empty()) {
        return families;
    }
    for (const RayFamily& family :
         families_from_inside(scene.corners, effort.timed_rays, effort.seed)) {
        if (family.name == "vertex") {
            families.push_back(std::make_shared<SpeedFamily>(
                SpeedFamily{family.name, upload_rays(family.rays), family.rays.size()}));
        }
    }
    return families;
}

} // namespace

TradeOffTrials speed_trade_off(const Scene& scene, const Effort& effort) {
    TradeOffTrials trade_off;
    trade_off.name = "speed only";
    trade_off.question = "Which choices change the speed and no hit? On " + scene.name + ".";
    trade_off.unit_of_cases = "ray";
    trade_off.kind = TradeOffKind::speed_only;
    const float reach = reach_of(origins_of(scene.camera), scene.corners);
    TraceRays judge(walk_parts("watertight", "bvh_ordered"), effort.limits);
    const auto judged = build_textures(scene, "bvh_ordered", reach, {});
    const auto families = families_of(scene, effort);
    for (const auto& family : families) {
        family->expected = read_hits(judge.closest_hits(family->rays, *judged), family->count);
    }
    std::map<std::string, std::shared_ptr<TraceRays>> tracers; // by structure
    for (const SpeedMethod& method : speed_methods()) {
        auto& trace = tracers[method.structure];
        if (!trace) {
            trace = std::make_shared<TraceRays>(walk_parts("watertight", method.structure),
                                                effort.limits);
        }
        const auto built = build_textures(scene, method.structure, reach, method.values);
        for (const auto& family : families) {
            trade_off.trials.push_back(
                {.method = method.name,
                 .family = family->name,
                 .timed_cases = family->count,
                 .run = [trace, family, built] { trace->closest_hits(family->rays, *built); },
                 .examine =
                     [trace, family, built] {
                         const Texture hits = trace->closest_hits(family->rays, *built);
                         return compare(read_hits(hits, family->count), *family, *built);
                     }});
        }
    }
    return trade_off;
}

} // namespace raysteps
