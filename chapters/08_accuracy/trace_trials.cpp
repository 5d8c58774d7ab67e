#include "trace_trials.h"

#include "judge_hits.h"
#include "reference/exact.h"

#include <algorithm>

namespace raysteps {

std::vector<std::shared_ptr<const TraceFamily>> with_truth(std::vector<RayFamily> families,
                                                           std::span<const glm::vec3> corners,
                                                           const Effort& effort) {
    std::vector<std::shared_ptr<const TraceFamily>> judged;
    for (RayFamily& family : families) {
        const std::size_t timed = std::min(effort.timed_rays, family.rays.size());
        RayTextures all = upload_rays(family.rays);
        RayTextures first = upload_rays(std::span(family.rays).first(timed));
        std::vector<ReferenceHit> truth = exact_nearest_hits(family.rays, corners);
        judged.push_back(std::make_shared<const TraceFamily>(
            TraceFamily{std::move(family.name), std::move(family.rays), std::move(truth), timed,
                        std::move(all), std::move(first)}));
    }
    return judged;
}

std::vector<Trial> trace_trials(const std::vector<TraceMethod>& methods,
                                const std::vector<std::shared_ptr<const TraceFamily>>& families,
                                std::span<const glm::vec3> corners, const Effort& effort) {
    std::vector<std::shared_ptr<TraceRays>> tracers;
    for (const TraceMethod& method : methods) {
        tracers.push_back(std::make_shared<TraceRays>(method.parts, effort.limits));
    }
    std::vector<Trial> trials;
    for (const auto& family : families) {
        for (std::size_t i = 0; i < methods.size(); ++i) {
            const auto trace = tracers[i];
            const auto scene = methods[i].scene;
            trials.push_back(
                {.method = methods[i].name,
                 .family = family->name,
                 .timed_cases = family->timed_count,
                 .run = [=] { trace->closest_hits(family->timed, *scene); }, // ends with a query
                 .examine =
                     [=] {
                         const Texture hits = trace->closest_hits(family->all, *scene);
                         return judge_hits(family->rays, read_hits(hits, family->rays.size()),
                                           family->truth, corners);
                     }});
        }
    }
    return trials;
}

} // namespace raysteps
