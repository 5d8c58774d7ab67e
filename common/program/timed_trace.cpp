#include "program/timed_trace.h"

#include "program/deliver.h"
#include "program/progress.h"
#include "program/tracing_options.h"
#include "scene/ray_file.h"

#include <chrono>
#include <cstdio>

namespace raysteps {

TimedTrace::TimedTrace(const Command& command, const Parts& parts, const SceneTextures& scene)
    : command_(command), scene_(scene), trace_(parts, measure_limits()) {
    trace_.report_progress(show_progress("tracing, " + command.structure));
}

Texture TimedTrace::closest_hits(const RayTextures& rays, std::size_t ray_count) {
    const auto start = std::chrono::steady_clock::now();
    Texture hits = trace_.closest_hits(rays, scene_);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rays_ = static_cast<double>(ray_count);
    return hits;
}

void TimedTrace::report() const {
    nlohmann::ordered_json numbers{{"scene", command_.scene},
                                   {"structure", command_.structure},
                                   {"triangle", command_.triangle},
                                   {"renderer", renderer_name()},
                                   {"triangles", scene_.triangle_count},
                                   {"rays", rays_},
                                   {"seconds", seconds_},
                                   {"million_rays_per_second", rays_ / seconds_ / 1e6}};
    std::printf("rays      %.0f in %.2f s: %.3g million a second\n", rays_, seconds_,
                rays_ / seconds_ / 1e6);
    if (command_.structure == "every_triangle") {
        const double tests = rays_ * scene_.triangle_count;
        std::printf("tests     %.0f in %.2f s: %.3g million a second\n", tests, seconds_,
                    tests / seconds_ / 1e6);
        numbers["tests"] = tests;
        numbers["million_tests_per_second"] = tests / seconds_ / 1e6;
    }
    for (const Fact& fact : scene_.structure.facts) {
        numbers[fact.name] = fact.value;
    }
    std::fflush(stdout);
    deliver_numbers(command_, numbers);
}

void trace_ray_file(const Command& command, const Parts& parts, const Scene& scene) {
    const std::vector<Ray> rays = read_ray_file(command.rays);
    const SceneTextures textures = upload(scene, build_structure(command, scene, rays));
    TimedTrace trace(command, parts, textures);
    const Texture hits = trace.closest_hits(upload_rays(rays), rays.size());
    write_hit_file(command.hits, read_hits(hits, rays.size()));
    std::printf("wrote     %s, %zu hits\n", command.hits.string().c_str(), rays.size());
    trace.report();
}

} // namespace raysteps
