#include "measure/measure_structures.h"

#include "gpu/context.h"
#include "measure/contest.h"
#include "measure/judge.h"
#include "measure/ray_kinds.h"
#include "render/rays.h"

#include <algorithm>
#include <cmath>
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

// Rays of one kind, or a part of them.
struct RaySet {
    RayKind kind;
    std::vector<std::size_t> numbers; // of its rays among all of the kind
    RayTextures textures;
};

// Of each `step` runs of rays, the first: rays from all over the picture, for a contender that
// cannot trace them all in the time there is.
RaySet every_nth_run(const RayKind& kind, std::size_t step) {
    RayKind sample{kind.name, kind.query, {}, kind.coherence};
    std::vector<std::size_t> numbers;
    for (std::size_t begin = 0; begin < kind.rays.size(); begin += step * rays_per_run) {
        for (std::size_t i = begin; i < std::min(begin + rays_per_run, kind.rays.size()); ++i) {
            sample.rays.push_back(kind.rays[i]);
            numbers.push_back(i);
        }
    }
    RayTextures textures = upload_rays(sample.rays);
    textures.coherence = kind.coherence;
    return {std::move(sample), std::move(numbers), std::move(textures)};
}

// The rays of one kind, and their samples, each made when it is asked for first.
class RaySets {
public:
    explicit RaySets(RayKind kind) : kind_(std::move(kind)) {}

    const RayKind& whole() const { return kind_; }

    // Of each `step` runs of rays, one.
    const RaySet& sample(std::size_t step) {
        const auto known = sets_.find(step);
        return known != sets_.end() ? known->second
                                    : sets_.emplace(step, every_nth_run(kind_, step)).first->second;
    }

private:
    RayKind kind_;
    std::map<std::size_t, RaySet> sets_;
};

// Who traces rays in one scene, whatever it is made of.
struct Tracer {
    std::string name;
    std::vector<Fact> facts;
    std::function<void(const RaySet&)> run;                 // to its end
    std::function<std::vector<Hit>(const RaySet&)> answers; // one for each ray
};

// A walk through its structure. All that is given must outlive it.
Tracer make_walker(const std::string& name, TraceRays& walk, const SceneTextures& scene) {
    return {.name = name,
            .facts = scene.structure.facts,
            .run =
                [&](const RaySet& rays) {
                    trace(walk, scene, rays.textures, rays.kind.query); // ends with a query
                },
            .answers =
                [&](const RaySet& rays) {
                    return read_hits(trace(walk, scene, rays.textures, rays.kind.query),
                                     rays.kind.rays.size());
                }};
}

// Of any hit, all that is known is whether there is one.
std::vector<Hit> embree_answers(const EmbreeScene& embree, const RayKind& kind, EmbreeCall call) {
    if (kind.query == Query::closest) {
        return embree.nearest_hits(kind.rays, call);
    }
    std::vector<Hit> hits;
    for (const std::uint8_t answer : embree.any_hits(kind.rays, call)) {
        hits.push_back({0.0f, 0.0f, 0.0f, answer != 0 ? 0 : no_triangle});
    }
    return hits;
}

// Embree rounds in its own way: what is compared is the triangle, or whether there is any hit.
std::size_t count_other_triangles(std::span<const Hit> embrees, const RaySet& rays,
                                  std::span<const Hit> ours) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < embrees.size(); ++i) {
        const int own = ours[rays.numbers[i]].triangle;
        const bool same = rays.kind.query == Query::any ? (embrees[i].triangle >= 0) == (own >= 0)
                                                        : embrees[i].triangle == own;
        different += same ? 0 : 1;
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
             .answers =
                 [embree, how = call](const RaySet& rays) {
                     return embree_answers(*embree, rays.kind, how);
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
                     .all_rays = sets.whole().rays.size()}};
}

// Our walks judge each other, and the loop judges them; Embree's other answers are counted. Throws
// DisputeError. The first walk answers for all rays where nobody else did.
void check_answers(std::vector<Entry>& entries, RaySets& sets, const Scene& scene,
                   const Tracer& first_walk, const LoopOverTriangles& loop) {
    std::vector<Answers> ours;
    for (const Entry& entry : entries) {
        if (!is_embree(entry.tracer.name)) {
            ours.push_back(
                {entry.tracer.name, entry.rays.numbers, entry.tracer.answers(entry.rays)});
        }
    }
    const auto has_all = [&](const Answers& own) {
        return own.rays.size() == sets.whole().rays.size();
    };
    if (std::ranges::none_of(ours, has_all)) {
        const RaySet& all = sets.sample(1);
        ours.push_back({first_walk.name, all.numbers, first_walk.answers(all)});
    }
    Judgement judgement = judge(scene, sets.whole(), ours, loop);
    if (judgement.dispute) {
        throw DisputeError(std::move(*judgement.dispute));
    }
    const std::vector<Hit>& agreed = std::ranges::find_if(ours, has_all)->hits;
    std::size_t walk = 0;
    for (Entry& entry : entries) {
        if (is_embree(entry.tracer.name)) {
            entry.costs.different =
                count_other_triangles(entry.tracer.answers(entry.rays), entry.rays, agreed);
        } else {
            entry.costs.judged = judgement.judged[walk++];
        }
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
        const auto million_rays = static_cast<double>(costs.rays) / 1e6;
        costs.rate = over_rounds(
            times[i], [&](const Seconds& seconds) { return million_rays / seconds.clock; });
        costs.cpu_rate = over_rounds(
            times[i], [&](const Seconds& seconds) { return million_rays / seconds.cpu; });
        costs.cores = over_rounds(times[i], [](const Seconds& seconds) {
                          return seconds.cpu / seconds.clock;
                      }).median;
    }
    const auto embree = std::ranges::find_if(
        entries, [](const Entry& entry) { return entry.tracer.name == embree_single; });
    if (embree == entries.end()) {
        return;
    }
    // Work on a GPU is no time of a processor.
    double Seconds::*const spent =
        runs_on_processor(renderer_name()) ? &Seconds::cpu : &Seconds::clock;
    const ContestTimes& beside = times[static_cast<std::size_t>(embree - entries.begin())];
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (!is_embree(entries[i].tracer.name)) {
            entries[i].costs.to_embree =
                speed_ratio(times[i], static_cast<double>(entries[i].costs.rays), beside,
                            static_cast<double>(embree->costs.rays), spent);
        }
    }
}

MeasureRequest with_first_walk(MeasureRequest request) {
    if (request.first_walk.empty()) {
        request.first_walk = request.structures.front().structure;
    }
    return request;
}

} // namespace

StructureContest::StructureContest(MeasureRequest request, const Limits& limits)
    : request_(with_first_walk(std::move(request))), limits_(limits),
      first_walk_(make_tracer(request_.triangle, request_.first_walk, limits)),
      loop_(walk_parts(request_.triangle, "every_triangle"), limits) {
    for (const StructureChoice& choice : request_.structures) {
        walks_.try_emplace(choice.structure,
                           make_tracer(request_.triangle, choice.structure, limits));
    }
}

SceneCosts StructureContest::measure(const Scene& scene, const Progress& progress) {
    const StructureChoice first_choice{request_.first_walk, request_.first_walk};
    const StructureChoice loop_choice{"every_triangle", "every_triangle"};
    std::vector<StructureChoice> choices = request_.structures;
    choices.insert(choices.end(), {first_choice, loop_choice});
    const BuiltStructures built(scene, choices, request_.build_values);
    std::vector<Tracer> tracers;
    for (const StructureChoice& choice : request_.structures) {
        tracers.push_back(make_walker(choice.text, walks_.at(choice.structure), built.of(choice)));
    }
    for (Tracer& tracer : make_embree(scene, request_.embree)) {
        tracers.push_back(std::move(tracer));
    }
    const Tracer first_walk = make_walker(first_choice.text, first_walk_, built.of(first_choice));
    const LoopOverTriangles loop = [&](const RayKind& kind) {
        return read_hits(trace(loop_, built.of(loop_choice), upload_rays(kind.rays), kind.query),
                         kind.rays.size());
    };
    SceneCosts costs{.scene = scene.name, .triangles = triangle_count(scene)};
    for (const Tracer& tracer : tracers) {
        costs.builds.push_back({tracer.name, tracer.facts});
    }

    const RayTextures camera =
        generate_rays(scene.camera, request_.width, request_.height, RayGeneration::direct);
    const std::vector<Hit> hits =
        in_blocks(read_hits(first_walk_.closest_hits(camera, built.of(first_choice))), request_);
    std::vector<RaySets> kinds;
    for (RayKind& kind : ray_kinds(scene, in_blocks(read_rays(camera), request_), hits, 1)) {
        if (std::find(request_.kinds.begin(), request_.kinds.end(), kind.name) !=
            request_.kinds.end()) {
            kinds.emplace_back(std::move(kind));
        }
    }
    const double steps = 2.0 * static_cast<double>(kinds.size()) + 1.0;
    double done = 0.0;
    std::vector<std::vector<Entry>> entries;
    for (RaySets& sets : kinds) {
        std::vector<Entry>& own = entries.emplace_back();
        for (const Tracer& tracer : tracers) {
            own.push_back(enter(tracer, sets, request_.most_seconds));
        }
        check_answers(own, sets, scene, first_walk, loop);
        progress(++done / steps);
    }
    // One program that counts at a time, and none while anything is measured: a driver keeps only
    // so many programs compiled.
    for (std::size_t i = 0; i < request_.structures.size(); ++i) {
        const StructureChoice& choice = request_.structures[i];
        TraceRays count = make_counting_tracer(request_.triangle, choice.structure, limits_);
        for (std::vector<Entry>& own : entries) {
            add_counts(own[i], count, built.of(choice));
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

} // namespace raysteps
