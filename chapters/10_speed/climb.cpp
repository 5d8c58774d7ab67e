#include "climb.h"

#include "gpu/context.h"
#include "measure/judge.h"
#include "measure/scene_costs.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace raysteps {

namespace {

const std::string loop_name = "every_triangle";

const SceneTextures& built_for(const BuiltStructures& built, const std::string& structure) {
    return built.of({structure, structure});
}

Texture trace(TraceRays& walk, const SceneTextures& scene, const RayTextures& rays, Query query) {
    return query == Query::any ? walk.any_hits(rays, scene) : walk.closest_hits(rays, scene);
}

// The rays of one kind as they lie in textures, and where each lies in the list.
struct LaidRays {
    RayTextures textures;
    std::vector<std::size_t> places; // of each ray of the kind
    ListLayout layout = ListLayout::blocks;
};

// A kind's rays come block by block. In rows they go as a person would list them: by the pixels
// that they come from, row by row.
LaidRays lay(const RayKind& kind, ListLayout layout, std::span<const std::size_t> pixels) {
    std::vector<std::size_t> order(kind.rays.size());
    std::iota(order.begin(), order.end(), 0);
    if (layout == ListLayout::rows) {
        std::ranges::sort(order, {}, [&](std::size_t ray) { return pixels[kind.from[ray]]; });
    }
    std::vector<Ray> list;
    std::vector<std::size_t> places(order.size());
    for (std::size_t place = 0; place < order.size(); ++place) {
        list.push_back(kind.rays[order[place]]);
        places[order[place]] = place;
    }
    RayTextures textures = upload_rays(list, layout);
    textures.coherence = kind.coherence;
    return {std::move(textures), std::move(places), layout};
}

// In the order of the kind.
std::vector<Hit> hits_of(const Texture& hits, const LaidRays& rays) {
    const std::vector<Hit> list =
        rays.layout == ListLayout::rows ? read_hits(hits) : read_hits(hits, rays.places.size());
    std::vector<Hit> own;
    for (const std::size_t place : rays.places) {
        own.push_back(list[place]);
    }
    return own;
}

// A kind of rays on one step: who traces it, and what.
struct Attempt {
    SpeedStep step;
    const RayKind& kind;
    const LaidRays& rays;
    TraceRays& walk;
    const SceneTextures& scene;
};

Texture run(const Attempt& attempt) {
    return trace(attempt.walk, attempt.scene, attempt.rays.textures, attempt.kind.query);
}

// What stays while a scene is measured.
struct Climber {
    const Scene& scene;
    BuiltStructures built;
    std::vector<std::size_t> pixels; // of the primary rays
    std::vector<RayKind> kinds;
    std::map<std::string, std::map<ListLayout, LaidRays>> laid{}; // by kind
    std::shared_ptr<EmbreeScene> embree{};
};

template <class Value>
std::vector<Value> picked(const std::vector<Value>& all, std::span<const std::size_t> numbers) {
    std::vector<Value> some;
    for (const std::size_t number : numbers) {
        some.push_back(all[number]);
    }
    return some;
}

Climber make_climber(const Scene& scene, TraceRays& walk, const ClimbRequest& request) {
    std::vector<std::string> structures{loop_name};
    for (const SpeedStep& step : speed_steps()) {
        structures.push_back(step.structure);
    }
    Climber climber{.scene = scene,
                    .built = {scene, plain_structures(structures), request.build_values},
                    .pixels = pixels_in_blocks(request.width, request.height),
                    .kinds = {}};
    const RayTextures camera =
        generate_rays(scene.camera, request.width, request.height, RayGeneration::direct);
    const Texture hits =
        walk.closest_hits(camera, built_for(climber.built, speed_steps().front().structure));
    climber.kinds = ray_kinds(scene, picked(read_rays(camera), climber.pixels),
                              picked(read_hits(hits), climber.pixels), 1);
    std::erase_if(climber.kinds, [](const RayKind& kind) { return kind.name == "reflection"; });
    for (const RayKind& kind : climber.kinds) {
        for (const ListLayout layout : {ListLayout::rows, ListLayout::blocks}) {
            climber.laid[kind.name].emplace(layout, lay(kind, layout, climber.pixels));
        }
    }
    if (request.embree != EmbreePart::none) {
        climber.embree = std::make_shared<EmbreeScene>(
            scene.corners,
            request.embree == EmbreePart::fast ? EmbreeMode::fast : EmbreeMode::robust);
    }
    return climber;
}

std::vector<Attempt> attempts_of(const Climber& climber, const RayKind& kind,
                                 std::map<std::string, TraceRays>& walks) {
    std::vector<Attempt> attempts;
    for (const SpeedStep& step : speed_steps()) {
        if (takes(kind, step)) {
            attempts.push_back({step, kind, climber.laid.at(kind.name).at(step.layout),
                                walks.at(step.structure),
                                built_for(climber.built, step.structure)});
        }
    }
    return attempts;
}

void check_answers(const Climber& climber, const RayKind& kind,
                   const std::vector<Attempt>& attempts, TraceRays& loop) {
    std::vector<std::size_t> all(kind.rays.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<Answers> answers;
    for (const Attempt& attempt : attempts) {
        answers.push_back({attempt.step.name, all, hits_of(run(attempt), attempt.rays)});
    }
    Judgement judgement = judge(climber.scene, kind, answers, [&](const RayKind& some) {
        const Texture hits =
            trace(loop, built_for(climber.built, loop_name), upload_rays(some.rays), some.query);
        return read_hits(hits, some.rays.size());
    });
    if (judgement.dispute) {
        throw DisputeError(std::move(*judgement.dispute));
    }
}

TraceRays make_counting_walk(const std::string& structure, const Limits& limits) {
    Parts parts = walk_parts("watertight", structure);
    parts["observer"] = "observer/count.glsl";
    return {std::move(parts), limits};
}

CountedVisits visits_in(const Texture& observations) {
    CountedVisits counted{observations.width(), observations.height(), {}};
    for (const glm::uvec4& texel : read_integers(observations)) {
        counted.visits.push_back(texel.x);
    }
    return counted;
}

// A driver keeps only so many programs compiled, so each walk that counts is made for its step
// alone, before anything is measured.
void add_counts(std::vector<KindCosts>& costs,
                const std::vector<std::vector<Attempt>>& attempts_of_kinds, const Limits& limits) {
    for (const SpeedStep& step : speed_steps()) {
        if (has_packets(step.structure)) {
            continue;
        }
        TraceRays count = make_counting_walk(step.structure, limits);
        for (std::size_t kind = 0; kind < costs.size(); ++kind) {
            for (std::size_t i = 0; i < attempts_of_kinds[kind].size(); ++i) {
                const Attempt& attempt = attempts_of_kinds[kind][i];
                if (attempt.step.name != step.name) {
                    continue;
                }
                trace(count, attempt.scene, attempt.rays.textures, attempt.kind.query);
                StepCosts& own = costs[kind].steps[i];
                for (const glm::uvec4& texel : read_integers(*count.observations())) {
                    own.visits_per_ray += texel.x;
                    own.tests_per_ray += texel.y;
                }
                own.visits_per_ray /= static_cast<double>(costs[kind].rays);
                own.tests_per_ray /= static_cast<double>(costs[kind].rays);
                own.lanes = lanes_at_work(visits_in(*count.observations()));
            }
        }
    }
}

void run_embree(const EmbreeScene& embree, const RayKind& kind) {
    if (kind.query == Query::any) {
        embree.any_hits(kind.rays, EmbreeCall::one_by_one);
    } else {
        embree.nearest_hits(kind.rays, EmbreeCall::one_by_one);
    }
}

// All kinds and all steps in one contest: kind by kind the attempts, and Embree behind them.
void add_times(std::vector<KindCosts>& costs, const Climber& climber,
               const std::vector<std::vector<Attempt>>& attempts_of_kinds, int rounds,
               const Progress& progress) {
    std::vector<Contender> contenders;
    for (const std::vector<Attempt>& attempts : attempts_of_kinds) {
        for (const Attempt& attempt : attempts) {
            contenders.push_back({attempt.step.name, [&] { run(attempt); }}); // ends with a query
        }
        if (climber.embree) {
            const RayKind& kind = attempts.front().kind;
            contenders.push_back({embree_single, [&] { run_embree(*climber.embree, kind); }});
        }
    }
    const std::vector<ContestTimes> times = run_contest(contenders, rounds, progress);
    double Seconds::*const spent =
        runs_on_processor(renderer_name()) ? &Seconds::cpu : &Seconds::clock;
    std::size_t first = 0; // of the contenders of a kind
    for (KindCosts& kind : costs) {
        const auto rays = static_cast<double>(kind.rays);
        const auto nanoseconds = [&](const ContestTimes& own) {
            return over_rounds(own, [&](const Seconds& one) { return one.*spent / rays * 1e9; });
        };
        const ContestTimes& yardstick = times[climber.embree ? first + kind.steps.size() : first];
        kind.yardstick = nanoseconds(yardstick);
        for (std::size_t i = 0; i < kind.steps.size(); ++i) {
            kind.steps[i].nanoseconds = nanoseconds(times[first + i]);
            kind.steps[i].ratio = speed_ratio(times[first + i], rays, yardstick, rays, spent);
        }
        first += kind.steps.size() + (climber.embree ? 1 : 0);
    }
}

} // namespace

std::string yardstick_of(const ClimbRequest& request) {
    return request.embree == EmbreePart::none ? speed_steps().front().name : embree_single;
}

std::map<std::string, TraceRays> make_step_walks(const Limits& limits) {
    std::map<std::string, TraceRays> walks;
    walks.try_emplace(loop_name, walk_parts("watertight", loop_name), limits);
    for (const SpeedStep& step : speed_steps()) {
        walks.try_emplace(step.structure, walk_parts("watertight", step.structure), limits,
                          Packets::always);
    }
    return walks;
}

ClimbedScene climb(const Scene& scene, std::map<std::string, TraceRays>& walks,
                   const Limits& limits, const ClimbRequest& request, const Progress& progress) {
    const Climber climber = make_climber(scene, walks.at(speed_steps().front().structure), request);
    ClimbedScene climbed{.scene = scene.name, .triangles = triangle_count(scene)};
    std::vector<std::vector<Attempt>> attempts;
    for (const RayKind& kind : climber.kinds) {
        attempts.push_back(attempts_of(climber, kind, walks));
        check_answers(climber, kind, attempts.back(), walks.at(loop_name));
        climbed.kinds.push_back({.kind = kind.name, .rays = kind.rays.size()});
        for (const Attempt& attempt : attempts.back()) {
            climbed.kinds.back().steps.push_back(
                {.step = attempt.step.name, .nanoseconds = {}, .ratio = {}});
        }
    }
    add_counts(climbed.kinds, attempts, limits);
    add_times(climbed.kinds, climber, attempts, request.rounds, progress);
    return climbed;
}

VisitCounter::VisitCounter(const Scene& scene, const std::vector<std::string>& structures,
                           const Limits& limits,
                           const std::map<std::string, std::string>& build_values)
    : built_(scene, plain_structures(structures), build_values) {
    for (const std::string& structure : structures) {
        walks_.emplace_back(structure, make_counting_walk(structure, limits));
    }
}

std::vector<CountedWalk> VisitCounter::count(const Camera& camera, int width, int height) {
    const RayTextures rays = generate_rays(camera, width, height, RayGeneration::direct);
    std::vector<CountedWalk> counted;
    for (auto& [structure, walk] : walks_) {
        walk.closest_hits(rays, built_for(built_, structure));
        counted.push_back({structure, visits_in(*walk.observations())});
    }
    return counted;
}

} // namespace raysteps
