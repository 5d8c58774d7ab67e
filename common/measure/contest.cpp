#include "measure/contest.h"

#include "basics/error.h"
#include "measure/measure_structures.h"
#include "measure/stopwatch.h"
#include "reference/embree/embree.h"
#include "render/rays.h"

#include <algorithm>
#include <memory>

namespace raysteps {

namespace {

const std::string judge = "bvh_ordered";
constexpr std::size_t probe_step = 16; // of the rays that tell how fast a contender is

std::size_t run_count(const RayKind& kind) {
    return (kind.rays.size() + rays_a_run - 1) / rays_a_run;
}

// How many runs of rays make one that can be traced in most_seconds: a power of 2, so that
// contenders share their samples.
std::size_t affordable_step(const Contender& contender, RaySets& sets, double most_seconds) {
    const std::size_t runs = run_count(sets.whole());
    const RaySet& probe = sets.sample(std::min(probe_step, runs));
    contender.run(probe); // some drivers compile at the first call
    const double seconds = seconds_of([&] { contender.run(probe); }).clock;
    const double of_all = seconds * static_cast<double>(sets.whole().rays.size()) /
                          static_cast<double>(probe.kind.rays.size());
    std::size_t step = 1;
    while (of_all > most_seconds * static_cast<double>(step) && step * 2 <= runs) {
        step *= 2;
    }
    return step;
}

// One contender with the rays that it can afford.
struct Entry {
    const Contender& contender;
    const RaySet& rays;
    ContestRow row;
    std::vector<Seconds> rounds;
};

Entry enter(const Contender& contender, RaySets& sets, const ContestRequest& request) {
    const RaySet& rays = sets.sample(affordable_step(contender, sets, request.most_seconds));
    ContestRow row{.contender = contender.name,
                   .kind = rays.kind.name,
                   .rays = rays.kind.rays.size(),
                   .all_rays = sets.whole().rays.size()};
    row.different = contender.count_different(rays);
    return {contender, rays, row, {}};
}

void check(const Entry& entry, const Scene& scene) {
    if (entry.row.different > 0 && !is_embree(entry.contender.name)) {
        throw Error(ExitCode::check_failed,
                    entry.contender.name + " and " + judge + " differ in " +
                        std::to_string(entry.row.different) + " of " +
                        std::to_string(entry.row.rays) + " " + entry.row.kind + " rays of " +
                        scene.name + ". With --triangle watertight, that is a fault of Raysteps.");
    }
}

void add_counts(Entry& entry, TraceRays& count, const SceneTextures& scene) {
    trace(count, scene, entry.rays.textures, entry.rays.kind.query);
    const double rays = static_cast<double>(entry.row.rays);
    for (const glm::uvec4& texel : read_integers(*count.observations())) {
        entry.row.visits_a_ray += texel.x / rays;
        entry.row.tests_a_ray += texel.y / rays;
    }
}

ContestRow finish(Entry entry) {
    std::vector<double> rates;
    std::vector<double> cores;
    for (const Seconds& seconds : entry.rounds) {
        rates.push_back(static_cast<double>(entry.row.rays) / seconds.clock / 1e6);
        cores.push_back(seconds.cpu / seconds.clock);
    }
    entry.row.rate = measured_range(rates);
    entry.row.cores = measured_range(cores).median;
    return entry.row;
}

} // namespace

Contest::Contest(ContestRequest request, const Limits& limits)
    : request_(std::move(request)), limits_(limits),
      judge_(walk_parts(request_.triangle, judge, "none"), limits) {
    if (request_.rounds < 1) {
        throw InputError("--rounds " + std::to_string(request_.rounds) +
                         ": there is nothing to measure. Take 1 or more.");
    }
    for (const std::string& structure : request_.structures) {
        walks_.emplace(structure,
                       TraceRays(walk_parts(request_.triangle, structure, "none"), limits));
    }
}

SceneResult Contest::measure(const Scene& scene, const Progress& progress) {
    std::vector<std::string> structures = request_.structures;
    structures.push_back(judge);
    const BuiltFamilies built = build_families(scene, structures, request_.build_values);
    std::vector<Contender> contenders;
    for (const std::string& structure : request_.structures) {
        contenders.push_back(
            make_contender(structure, walks_.at(structure), built_for(built, structure)));
    }
    for (Contender& contender : make_embree(scene, request_.embree)) {
        contenders.push_back(std::move(contender));
    }

    SceneResult result{.scene = scene.name, .triangles = triangle_count(scene)};
    for (const Contender& contender : contenders) {
        result.builds.push_back({contender.name, contender.facts});
    }
    const RayTextures camera =
        generate_rays(scene.camera, request_.width, request_.height, RayGeneration::direct);
    const std::vector<Hit> hits = read_hits(judge_.closest_hits(camera, built_for(built, judge)));
    std::vector<RaySets> kinds;
    for (RayKind& kind : ray_kinds(scene, read_rays(camera), hits, 1)) {
        kinds.emplace_back(std::move(kind), judge_, built_for(built, judge));
    }
    const double steps = static_cast<double>(kinds.size()) * (request_.rounds + 2) + 1.0;
    double done = 0.0;
    std::vector<std::vector<Entry>> entries;
    for (RaySets& sets : kinds) {
        std::vector<Entry>& own = entries.emplace_back();
        for (const Contender& contender : contenders) {
            own.push_back(enter(contender, sets, request_));
            check(own.back(), scene);
        }
        progress(++done / steps);
    }
    // One program that counts at a time, and none while anything is measured: a driver keeps only
    // so many programs compiled.
    for (std::size_t i = 0; i < request_.structures.size(); ++i) {
        const std::string& structure = request_.structures[i];
        TraceRays count(walk_parts(request_.triangle, structure, "count"), limits_);
        for (std::vector<Entry>& own : entries) {
            add_counts(own[i], count, built_for(built, structure));
        }
    }
    progress(++done / steps);
    for (std::vector<Entry>& own : entries) {
        for (int round = 0; round <= request_.rounds; ++round) {
            for (Entry& entry : own) {
                const Seconds seconds = seconds_of([&] { entry.contender.run(entry.rays); });
                if (round > 0) { // the first warms the caches
                    entry.rounds.push_back(seconds);
                }
            }
            progress(++done / steps);
        }
        for (Entry& entry : own) {
            result.rows.push_back(finish(std::move(entry)));
        }
    }
    return result;
}

namespace {

// Embree rounds in its own way: what is compared is the triangle, or whether there is any hit.
std::size_t count_other_triangles(const EmbreeScene& embree, const RaySet& rays, EmbreeCall call) {
    std::size_t different = 0;
    if (rays.kind.query == Query::any) {
        const std::vector<std::uint8_t> answers = embree.any_hits(rays.kind.rays, call);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            different += (answers[i] != 0) == (rays.expected[i].triangle >= 0) ? 0 : 1;
        }
        return different;
    }
    const std::vector<Hit> hits = embree.nearest_hits(rays.kind.rays, call);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        different += hits[i].triangle == rays.expected[i].triangle ? 0 : 1;
    }
    return different;
}

void run_embree(const EmbreeScene& embree, const RaySet& rays, EmbreeCall call) {
    if (rays.kind.query == Query::any) {
        embree.any_hits(rays.kind.rays, call);
    } else {
        embree.nearest_hits(rays.kind.rays, call);
    }
}

} // namespace

Contender make_contender(const std::string& structure, TraceRays& walk,
                         const SceneTextures& scene) {
    return {.name = structure,
            .facts = scene.structure.facts,
            .run =
                [&](const RaySet& rays) {
                    trace(walk, scene, rays.textures, rays.kind.query); // ends with a query
                },
            .count_different =
                [&](const RaySet& rays) {
                    const Texture hits = trace(walk, scene, rays.textures, rays.kind.query);
                    return count_other_answers(read_hits(hits, rays.kind.rays.size()),
                                               rays.expected, rays.kind.query);
                }};
}

std::vector<Contender> make_embree(const Scene& scene, EmbreePart part) {
    if (part == EmbreePart::none) {
        return {};
    }
    const auto embree = std::make_shared<EmbreeScene>(
        scene.corners, part == EmbreePart::fast ? EmbreeMode::fast : EmbreeMode::robust);
    std::vector<Contender> contenders;
    for (const auto& [name, call] : {std::pair{embree_single, EmbreeCall::one_by_one},
                                     std::pair{embree_packets, EmbreeCall::packets}}) {
        contenders.push_back(
            {.name = name,
             .facts = {{"build_seconds", embree->build_seconds()}},
             .run = [embree, how = call](const RaySet& rays) { run_embree(*embree, rays, how); },
             .count_different =
                 [embree, how = call](const RaySet& rays) {
                     return count_other_triangles(*embree, rays, how);
                 }});
    }
    return contenders;
}

} // namespace raysteps
