#include "command/timed_trace.h"

#include "command/deliver.h"
#include "command/progress.h"
#include "command/tracing_options.h"
#include "scene/ray_file.h"

#include <chrono>
#include <cstdio>

namespace raysteps {

TimedTrace::TimedTrace(const Command& command, const Parts& parts, const SceneTextures& scene)
    : command_(command), scene_(scene), trace_(parts, measure_limits()) {
    trace_.report_progress(show_progress("testing every triangle"));
}

Texture TimedTrace::closest_hits(const RayTextures& rays, std::size_t ray_count) {
    const auto start = std::chrono::steady_clock::now();
    Texture hits = trace_.closest_hits(rays, scene_);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    tests_ = static_cast<double>(ray_count) * scene_.triangle_count;
    return hits;
}

void TimedTrace::report() const {
    const double millions_per_second = tests_ / seconds_ / 1e6;
    std::printf("tests     %.0f in %.2f s: %.3g million a second\n", tests_, seconds_,
                millions_per_second);
    std::fflush(stdout);
    deliver_numbers(command_, {{"scene", command_.scene},
                               {"triangle", command_.triangle},
                               {"renderer", renderer_name()},
                               {"triangles", scene_.triangle_count},
                               {"tests", tests_},
                               {"seconds", seconds_},
                               {"million_tests_per_second", millions_per_second}});
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
