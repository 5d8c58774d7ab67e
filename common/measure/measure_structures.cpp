#include "measure/measure_structures.h"

#include "basics/error.h"
#include "measure/contest.h"
#include "measure/ray_kinds.h"
#include "render/rays.h"
#include "structure/padding.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

namespace raysteps {

namespace {

// Of a structure that is named for its packets, the contest measures packets, however few rays
// there are.
TraceRays make_tracer(const std::string& triangle, const std::string& structure,
                      const Limits& limits) {
    return {walk_parts(triangle, structure), limits,
            structure == "fastest" ? Packets::where_faster : Packets::always};
}

TraceRays make_counting_tracer(const std::string& triangle, const std::string& structure,
                               const Limits& limits) {
    Parts parts = walk_parts(triangle, structure);
    parts["observer"] = "observer/count.glsl";
    return {std::move(parts), limits};
}

Texture trace(TraceRays& tracer, const SceneTextures& scene, const RayTextures& rays, Query query) {
    return query == Query::any ? tracer.any_hits(rays, scene) : tracer.closest_hits(rays, scene);
}

bool is_same_answer(const Hit& a, const Hit& b, Query query) {
    if (a.triangle < 0 || b.triangle < 0 || query == Query::any) {
        return (a.triangle < 0) == (b.triangle < 0);
    }
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// A scene with a built structure of each family, by the family's name.
using BuiltFamilies = std::map<std::string, SceneTextures>;

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

// Builds each family of these structures once, for all its walks.
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

// What a picture has for its pixels as a list in which neighbours stay neighbours.
template <class Value>
std::vector<Value> in_blocks(const std::vector<Value>& picture, const MeasureRequest& request) {
    std::vector<Value> list;
    for (const std::size_t pixel : pixels_in_blocks(request.width, request.height)) {
        list.push_back(picture[pixel]);
    }
    return list;
}

// Neighbours in a run are as coherent as in the whole.
constexpr std::size_t rays_per_run = 64;

std::size_t run_count(const RayKind& kind) {
    return (kind.rays.size() + rays_per_run - 1) / rays_per_run;
}

// Of each `step` runs of rays, the first: rays from all over the picture, for a contender that
// cannot trace them all in the time there is.
RayKind every_nth_run(const RayKind& kind, std::size_t step) {
    RayKind sample{kind.name, kind.query, {}, kind.coherence};
    for (std::size_t begin = 0; begin < kind.rays.size(); begin += step * rays_per_run) {
        const std::size_t end = std::min(begin + rays_per_run, kind.rays.size());
        sample.rays.insert(sample.rays.end(),
                           kind.rays.begin() + static_cast<std::ptrdiff_t>(begin),
                           kind.rays.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return sample;
}

// Rays of one kind, or a part of them, with the answers that all have to give.
struct RaySet {
    RayKind kind;
    RayTextures textures;
    std::vector<Hit> expected;
};

// The rays of one kind, and their samples, each made when it is asked for first.
class RaySets {
public:
    RaySets(RayKind kind, TraceRays& judge, const SceneTextures& scene)
        : kind_(std::move(kind)), judge_(judge), scene_(scene) {}

    const RayKind& whole() const { return kind_; }

    // Of each `step` runs of rays, one.
    const RaySet& sample(std::size_t step) {
        const auto known = sets_.find(step);
        if (known != sets_.end()) {
            return known->second;
        }
        RayKind kind = every_nth_run(kind_, step);
        RayTextures textures = upload_rays(kind.rays);
        textures.coherence = kind.coherence;
        std::vector<Hit> expected =
            read_hits(trace(judge_, scene_, textures, kind.query), kind.rays.size());
        return sets_
            .emplace(step, RaySet{std::move(kind), std::move(textures), std::move(expected)})
            .first->second;
    }

private:
    RayKind kind_;
    TraceRays& judge_;
    const SceneTextures& scene_;
    std::map<std::size_t, RaySet> sets_;
};

// Who traces rays in one scene, whatever it is made of.
struct Tracer {
    std::string name;
    std::vector<Fact> facts;
    std::function<void(const RaySet&)> run;                    // to its end
    std::function<std::size_t(const RaySet&)> count_different; // answers
};

// A walk through its structure. All that is given must outlive it.
Tracer make_walker(const std::string& structure, TraceRays& walk, const SceneTextures& scene) {
    return {.name = structure,
            .facts = scene.structure.facts,
            .run =
                [&](const RaySet& rays) {
                    trace(walk, scene, rays.textures, rays.kind.query); // ends with a query
                },
            .count_different =
                [&](const RaySet& rays) {
                    const std::vector<Hit> hits = read_hits(
                        trace(walk, scene, rays.textures, rays.kind.query), rays.kind.rays.size());
                    std::size_t different = 0;
                    for (std::size_t i = 0; i < hits.size(); ++i) {
                        different +=
                            is_same_answer(hits[i], rays.expected[i], rays.kind.query) ? 0 : 1;
                    }
                    return different;
                }};
}

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

// Embree by single rays and by packets; nobody where the part is none.
std::vector<Tracer> make_embree(const Scene& scene, EmbreePart part) {
    if (part == EmbreePart::none) {
        return {};
    }
    const auto embree = std::make_shared<EmbreeScene>(
        scene.corners, part == EmbreePart::fast ? EmbreeMode::fast : EmbreeMode::robust);
    std::vector<Tracer> tracers;
    for (const auto& [name, call] : {std::pair{embree_single, EmbreeCall::one_by_one},
                                     std::pair{embree_packets, EmbreeCall::packets}}) {
        tracers.push_back(
            {.name = name,
             .facts = {{"build_seconds", embree->build_seconds()}},
             .run = [embree, how = call](const RaySet& rays) { run_embree(*embree, rays, how); },
             .count_different =
                 [embree, how = call](const RaySet& rays) {
                     return count_other_triangles(*embree, rays, how);
                 }});
    }
    return tracers;
}

constexpr std::size_t probe_step = 16; // of the rays that tell how fast a tracer is

// How many runs of rays make one that can be traced in most_seconds: a power of 2, so that tracers
// share their samples.
std::size_t affordable_step(const Tracer& tracer, RaySets& sets, double most_seconds) {
    if (std::isinf(most_seconds)) {
        return 1;
    }
    const std::size_t runs = run_count(sets.whole());
    const RaySet& probe = sets.sample(std::min(probe_step, runs));
    tracer.run(probe); // some drivers compile at the first call
    const double seconds = seconds_of([&] { tracer.run(probe); }).clock;
    const double of_all = seconds * static_cast<double>(sets.whole().rays.size()) /
                          static_cast<double>(probe.kind.rays.size());
    std::size_t step = 1;
    while (of_all > most_seconds * static_cast<double>(step) && step * 2 <= runs) {
        step *= 2;
    }
    return step;
}

// One tracer with the rays that it can afford.
struct Entry {
    const Tracer& tracer;
    const RaySet& rays;
    RayCosts costs;
};

Entry enter(const Tracer& tracer, RaySets& sets, double most_seconds) {
    const RaySet& rays = sets.sample(affordable_step(tracer, sets, most_seconds));
    return {tracer, rays,
            RayCosts{.contender = tracer.name,
                     .kind = rays.kind.name,
                     .rays = rays.kind.rays.size(),
                     .all_rays = sets.whole().rays.size(),
                     .different = tracer.count_different(rays)}};
}

void check_answers(const RayCosts& costs, const std::string& judge, const Scene& scene) {
    if (costs.different > 0 && !is_embree(costs.contender)) {
        throw Error(ExitCode::check_failed,
                    fmt::format("{} and {} differ in {} of {} {} rays of {}. With --triangle "
                                "watertight, that is a bug in Raysteps; please report it.",
                                costs.contender, judge, costs.different, costs.rays, costs.kind,
                                scene.name));
    }
}

void add_counts(Entry& entry, TraceRays& count, const SceneTextures& scene) {
    trace(count, scene, entry.rays.textures, entry.rays.kind.query);
    for (const glm::uvec4& texel : read_integers(*count.observations())) {
        entry.costs.visits_per_ray += texel.x;
        entry.costs.tests_per_ray += texel.y;
    }
    entry.costs.visits_per_ray /= static_cast<double>(entry.costs.rays);
    entry.costs.tests_per_ray /= static_cast<double>(entry.costs.rays);
}

// Measures those that trace rays of one kind, in one contest.
void measure_rates(std::vector<Entry>& entries, int rounds, const Progress& progress) {
    std::vector<Contender> contenders;
    for (const Entry& entry : entries) {
        contenders.push_back({entry.tracer.name, [&] { entry.tracer.run(entry.rays); }});
    }
    const std::vector<ContestTimes> times = run_contest(contenders, rounds, progress);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        RayCosts& costs = entries[i].costs;
        costs.rate = over_rounds(times[i], [&](const Seconds& seconds) {
            return static_cast<double>(costs.rays) / seconds.clock / 1e6;
        });
        costs.cores = over_rounds(times[i], [](const Seconds& seconds) {
                          return seconds.cpu / seconds.clock;
                      }).median;
    }
}

MeasureRequest with_judge(MeasureRequest request) {
    if (request.judge.empty()) {
        request.judge = request.structures.front();
    }
    return request;
}

} // namespace

double fact_of(const BuildCosts& build, const std::string& name) {
    const auto fact = std::find_if(build.facts.begin(), build.facts.end(),
                                   [&](const Fact& one) { return one.name == name; });
    return fact == build.facts.end() ? 0.0 : fact->value;
}

const RayCosts* fastest_walk(const SceneCosts& costs, const std::string& kind) {
    const RayCosts* fastest = nullptr;
    for (const RayCosts& rays : costs.rays) {
        if (rays.kind == kind && !is_embree(rays.contender) &&
            (fastest == nullptr || rays.rate.median > fastest->rate.median)) {
            fastest = &rays;
        }
    }
    return fastest;
}

std::optional<EmbreeRatio> ratio_to_embree(const SceneCosts& costs, const std::string& kind) {
    const RayCosts* const ours = fastest_walk(costs, kind);
    const auto embree = std::ranges::find_if(costs.rays, [&](const RayCosts& rays) {
        return rays.kind == kind && rays.contender == embree_single;
    });
    if (ours == nullptr || embree == costs.rays.end()) {
        return std::nullopt;
    }
    const double ratio = ours->rate.median / embree->rate.median;
    return EmbreeRatio{ratio, ratio * embree->cores / ours->cores};
}

StructureContest::StructureContest(MeasureRequest request, const Limits& limits)
    : request_(with_judge(std::move(request))), limits_(limits),
      judge_(make_tracer(request_.triangle, request_.judge, limits)) {
    for (const std::string& structure : request_.structures) {
        walks_.emplace(structure, make_tracer(request_.triangle, structure, limits));
    }
}

SceneCosts StructureContest::measure(const Scene& scene, const Progress& progress) {
    std::vector<std::string> structures = request_.structures;
    structures.push_back(request_.judge);
    const BuiltFamilies built = build_families(scene, structures, request_.build_values);
    const SceneTextures& judged = built_for(built, request_.judge);
    std::vector<Tracer> tracers;
    for (const std::string& structure : request_.structures) {
        tracers.push_back(
            make_walker(structure, walks_.at(structure), built_for(built, structure)));
    }
    for (Tracer& tracer : make_embree(scene, request_.embree)) {
        tracers.push_back(std::move(tracer));
    }
    SceneCosts costs{.scene = scene.name, .triangles = triangle_count(scene)};
    for (const Tracer& tracer : tracers) {
        costs.builds.push_back({tracer.name, tracer.facts});
    }

    const RayTextures camera =
        generate_rays(scene.camera, request_.width, request_.height, RayGeneration::direct);
    const std::vector<Hit> hits =
        in_blocks(read_hits(judge_.closest_hits(camera, judged)), request_);
    std::vector<RaySets> kinds;
    for (RayKind& kind : ray_kinds(scene, in_blocks(read_rays(camera), request_), hits, 1)) {
        if (std::find(request_.kinds.begin(), request_.kinds.end(), kind.name) !=
            request_.kinds.end()) {
            kinds.emplace_back(std::move(kind), judge_, judged);
        }
    }
    const double steps = 2.0 * static_cast<double>(kinds.size()) + 1.0;
    double done = 0.0;
    std::vector<std::vector<Entry>> entries;
    for (RaySets& sets : kinds) {
        std::vector<Entry>& own = entries.emplace_back();
        for (const Tracer& tracer : tracers) {
            own.push_back(enter(tracer, sets, request_.most_seconds));
            check_answers(own.back().costs, request_.judge, scene);
        }
        progress(++done / steps);
    }
    // One program that counts at a time, and none while anything is measured: a driver keeps only
    // so many programs compiled.
    for (std::size_t i = 0; i < request_.structures.size(); ++i) {
        const std::string& structure = request_.structures[i];
        TraceRays count = make_counting_tracer(request_.triangle, structure, limits_);
        for (std::vector<Entry>& own : entries) {
            add_counts(own[i], count, built_for(built, structure));
        }
    }
    progress(++done / steps);
    for (std::vector<Entry>& own : entries) {
        measure_rates(own, request_.rounds,
                      [&](double part_done) { progress((done + part_done) / steps); });
        done += 1.0;
        for (const Entry& entry : own) {
            costs.rays.push_back(entry.costs);
        }
    }
    return costs;
}

std::string to_table(const SceneCosts& costs) {
    std::string table =
        "structure        rays        visits/ray  tests/ray  million rays/s (range)\n";
    for (const BuildCosts& build : costs.builds) {
        for (const RayCosts& rays : costs.rays) {
            if (rays.contender == build.contender) {
                table +=
                    fmt::format("{:16} {:10} {:11.2f} {:10.2f}  {:.3g} ({:.3g} to {:.3g})\n",
                                rays.contender, rays.kind, rays.visits_per_ray, rays.tests_per_ray,
                                rays.rate.median, rays.rate.lowest, rays.rate.highest);
            }
        }
    }
    return table;
}

} // namespace raysteps
