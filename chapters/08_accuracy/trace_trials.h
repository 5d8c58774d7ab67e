#pragma once

#include "effort.h"
#include "hard_cases/aimed_rays.h"
#include "knob.h"
#include "reference/exact.h"
#include "render/scene_textures.h"
#include "render/trace_rays.h"

#include <memory>
#include <vector>

namespace raysteps {

// A program that traces, by the parts of its slots, through the structure that it is given.
struct TraceMethod {
    std::string name;
    Parts parts;
    std::shared_ptr<const SceneTextures> scene;
};

// Rays on the GPU, with the true hits; the first of them also by themselves, to be timed.
struct TraceFamily {
    std::string name;
    std::vector<Ray> rays;
    std::vector<ReferenceHit> truth;
    std::size_t timed_count = 0;
    RayTextures all;
    RayTextures timed;
};

// The families with the truth of exact arithmetic on the float inputs.
std::vector<std::shared_ptr<const TraceFamily>> with_truth(std::vector<RayFamily> families,
                                                           std::span<const glm::vec3> corners,
                                                           const Effort& effort);

// Each method on each family: nearest hits, judged by 08_accuracy/judge_hits.h. The corners must
// outlive the trials. A context must be current as long as they live.
std::vector<Trial> trace_trials(const std::vector<TraceMethod>& methods,
                                const std::vector<std::shared_ptr<const TraceFamily>>& families,
                                std::span<const glm::vec3> corners, const Effort& effort);

} // namespace raysteps
