#pragma once

#include "basics/error.h"
#include "basics/threads.h"
#include "mirror/walks.h"
#include "walk_recorder.h"

#include <limits>
#include <map>
#include <string>
#include <utility>

namespace raysteps {

// What tells one step of a family from its events. The tests that follow a visit belong to it.
//   Explain(mirror, ray, input): prepares
//   bool explain.knows(mirror, place): whether the structure has that place
//   Step explain.visit(mirror, place, nearest): what is known when the walk comes to a place
//   void explain.leave(step): when the walk comes to the next one
//   Ending explain.ending(walk): why there was no further step

constexpr float near_enough_for(Question question) {
    constexpr float farthest = std::numeric_limits<float>::max();
    return question == Question::any ? farthest : -farthest;
}

// Runs the whole walk with a mirror::Recorder.
template <class Mirror>
Hit run_walk(Mirror& mirror, const Ray& ray, Question question) {
    mirror.observer.events.clear();
    return mirror::from_mirror(
        mirror.find_hit(mirror::to_mirror<Mirror>(ray), near_enough_for(question)));
}

// One test more at the end of the walk, made again by the same text: so it gives the same bits.
template <class Mirror, class Prepared>
void add_test(RecordedWalk& walk, Mirror& mirror, const Prepared& ray, int triangle,
              typename Mirror::Hit& nearest) {
    const auto hit = mirror.intersect_triangle(ray, mirror.triangle_corner(triangle, 0),
                                               mirror.triangle_corner(triangle, 1),
                                               mirror.triangle_corner(triangle, 2), triangle);
    const bool best = mirror.is_nearer(hit, nearest);
    if (best) {
        nearest = hit;
    }
    walk.tests.push_back({triangle, mirror::from_mirror(hit), best});
}

// A walk, and what each of its events means.
template <class Mirror, class Explain>
RecordedWalk record_with(const RecorderInput& input, const Ray& ray, Question question) {
    auto mirror = mirror::mirror_of<Mirror>(input.scene, input.packed);
    RecordedWalk walk;
    walk.ray = ray;
    walk.question = question;
    walk.hit = run_walk(mirror, ray, question);
    const std::vector<mirror::WalkEvent> events = std::exchange(mirror.observer.events, {});
    const auto mirror_ray = mirror::to_mirror<Mirror>(ray);
    const auto prepared = mirror.prepare_ray(mirror_ray);
    auto nearest = mirror.miss(mirror_ray);
    Explain explain(mirror, mirror_ray, input);
    for (const mirror::WalkEvent& event : events) {
        const bool is_visit = event.kind == mirror::WalkEvent::Kind::visit;
        if (is_visit || explain.each_test_is_a_step) {
            if (!walk.steps.empty()) {
                explain.leave(walk.steps.back());
            }
            Step step = explain.visit(mirror, event.number, nearest);
            step.place = event.number;
            step.first_test = step.end_test = walk.tests.size();
            step.nearest = mirror::from_mirror(nearest);
            walk.steps.push_back(step);
        }
        if (!is_visit) {
            add_test(walk, mirror, prepared, event.number, nearest);
            walk.steps.back().end_test = walk.tests.size();
            walk.steps.back().nearest = mirror::from_mirror(nearest);
        }
    }
    walk.ending = explain.ending(walk);
    return walk;
}

// What a walk tells, step by step: its own places, tests and hits, and what they mean here.
template <class Mirror, class Explain>
RecordedWalk explain_with(const RecorderInput& input, const ToldWalk& told) {
    auto mirror = mirror::mirror_of<Mirror>(input.scene, input.packed);
    const int triangles = static_cast<int>(input.scene.corners.size() / 3);
    RecordedWalk walk;
    walk.told_by = told.name;
    walk.ray = told.ray;
    walk.question = told.question;
    walk.hit = told.hit;
    const auto mirror_ray = mirror::to_mirror<Mirror>(told.ray);
    const auto prepared = mirror.prepare_ray(mirror_ray);
    auto nearest = mirror.miss(mirror_ray);
    Explain explain(mirror, mirror_ray, input);
    for (const ToldStep& said : told.steps) {
        if (!walk.steps.empty() && walk.steps.back().cell != no_cell) {
            explain.leave(walk.steps.back());
        }
        Step step;
        if (explain.knows(mirror, said.place)) {
            step = explain.visit(mirror, said.place, nearest);
        }
        step.place = said.place;
        step.round = said.round;
        step.first_test = walk.tests.size();
        for (const int triangle : said.tested) {
            if (triangle < 0 || triangle >= triangles) {
                throw InputError(told.name + ": the walk tests triangle " +
                                 std::to_string(triangle) + ", but the scene has " +
                                 std::to_string(triangles) + ". Name the scene of the walk.");
            }
            add_test(walk, mirror, prepared, triangle, nearest);
        }
        step.end_test = walk.tests.size();
        step.nearest = said.nearest;
        nearest = {said.nearest.t, said.nearest.u, said.nearest.v, said.nearest.triangle};
        walk.steps.push_back(step);
    }
    walk.ending = told.ended ? Ending::told : Ending::cut;
    return walk;
}

// The recorder of one mirror.
template <class Mirror, class Explain>
WalkRecorder recorder_of(const RecorderInput& input) {
    WalkRecorder recorder;
    recorder.record = [input](const Ray& ray, Question question) {
        return record_with<Mirror, Explain>(input, ray, question);
    };
    recorder.explain = [input](const ToldWalk& told) {
        return explain_with<Mirror, Explain>(input, told);
    };
    recorder.count = [input](std::span<const Ray> rays) {
        std::vector<WalkCount> counts(rays.size());
        in_parts(all_cores, rays.size(), 1024, [&](std::size_t begin, std::size_t end) {
            auto mirror = mirror::mirror_of<Mirror>(input.scene, input.packed);
            for (std::size_t i = begin; i < end; ++i) {
                run_walk(mirror, rays[i], Question::nearest);
                for (const mirror::WalkEvent& event : mirror.observer.events) {
                    ++(event.kind == mirror::WalkEvent::Kind::visit ? counts[i].visits
                                                                    : counts[i].tests);
                }
            }
        });
        return counts;
    };
    return recorder;
}

// Whether a walk ended in its last step because any hit would do.
inline bool ended_at_any_hit(const RecordedWalk& walk) {
    return walk.question == Question::any && walk.hit.triangle != no_triangle;
}

// How the walks of a folder of shaders/structure are recorded, by their names.
using MakeRecorder = WalkRecorder (*)(const RecorderInput&);
using Recorders = std::map<std::string, MakeRecorder>;

Recorders loop_recorders();
Recorders grid_recorders();
Recorders kd_tree_recorders();
Recorders bvh_recorders();

} // namespace raysteps
