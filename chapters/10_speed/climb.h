#pragma once

#include "lanes.h"
#include "measure/built_structures.h"
#include "measure/contest.h"
#include "reference/embree/embree.h"
#include "render/trace_rays.h"
#include "scene/scene.h"
#include "steps.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

struct ClimbRequest {
    EmbreePart embree = EmbreePart::none;
    int width = 256; // of the picture whose rays are traced
    int height = 256;
    int rounds = 9;                                    // after one that is dropped
    std::map<std::string, std::string> build_values{}; // the file of a tree, where one is named
};

// What rays of one kind cost after a step.
struct StepCosts {
    std::string step;
    MeasuredRange nanoseconds; // of processor time a ray, all threads together
    MeasuredRange ratio;       // of rays a second to those of the yardstick, round by round
    double visits_per_ray = 0.0;
    double tests_per_ray = 0.0;
    std::optional<double> lanes{}; // the part that is at work; nobody observes packets
};

struct KindCosts {
    std::string kind;
    std::size_t rays = 0;
    std::vector<StepCosts> steps{}; // those that the kind takes
    MeasuredRange yardstick{};      // nanoseconds a ray
};

struct ClimbedScene {
    std::string scene;
    int triangles = 0;
    std::vector<KindCosts> kinds{};
};

// The name of whom the ratios are to: Embree by single rays, or without it the first step.
std::string yardstick_of(const ClimbRequest& request);

// The walks of all steps, by the names of their structures; compiled once for all scenes.
std::map<std::string, TraceRays> make_step_walks(const Limits& limits);

// Takes a scene's primary, shadow and bounce rays up all steps, and Embree beside them, in one
// contest by processor time (on a GPU, whose work is no time of a processor, by the clock). All
// steps must give the same answers, and the loop over every triangle judges them (measure/judge.h).
// Throws DisputeError where it does not agree.
ClimbedScene climb(const Scene& scene, std::map<std::string, TraceRays>& walks,
                   const Limits& limits, const ClimbRequest& request, const Progress& progress);

// Counts what the walks of some structures visit in a scene.
class VisitCounter {
public:
    VisitCounter(const Scene& scene, const std::vector<std::string>& structures,
                 const Limits& limits, const std::map<std::string, std::string>& build_values = {});

    // For each pixel of the camera's picture, walk by walk.
    std::vector<CountedWalk> count(const Camera& camera, int width, int height);

private:
    BuiltStructures built_;
    std::vector<std::pair<std::string, TraceRays>> walks_;
};

} // namespace raysteps
