#include "trace_loop.h"

#include "command/deliver.h"
#include "command/progress.h"
#include "error/error.h"
#include "gpu/shader_catalog.h"
#include "scene/ray_file.h"

#include <chrono>
#include <cstdio>
#include <iostream>

namespace raysteps {

Parts trace_parts(const Command& command) {
    return {{"triangle", find_part("triangle", command.triangle)}};
}

TraceLoop::TraceLoop(const Command& command, const Parts& parts, const SceneTextures& scene)
    : command_(command), scene_(scene), trace_(parts, measure_limits()) {
    trace_.report_progress(show_progress("testing every triangle"));
}

Texture TraceLoop::closest_hits(const RayTextures& rays) {
    const auto start = std::chrono::steady_clock::now();
    Texture hits = trace_.closest_hits(rays, scene_);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    tests_ =
        static_cast<double>(rays.origins.width()) * rays.origins.height() * scene_.triangle_count;
    return hits;
}

void TraceLoop::trace_ray_file() {
    const std::vector<Ray> rays = read_ray_file(command_.rays);
    const Texture hits = closest_hits(upload_rays(rays));
    write_hit_file(command_.hits, read_hits(hits, rays.size()));
    std::cout << "wrote     " << command_.hits.string() << ", " << rays.size() << " hits\n";
    report();
}

void TraceLoop::report() const {
    const double millions_per_second = tests_ / seconds_ / 1e6;
    std::printf("tests     %.0f million in %.2f s: %.0f million a second\n", tests_ / 1e6, seconds_,
                millions_per_second);
    deliver_numbers(command_, {{"scene", command_.scene},
                               {"triangle", command_.triangle},
                               {"renderer", renderer_name()},
                               {"triangles", scene_.triangle_count},
                               {"tests", tests_},
                               {"seconds", seconds_},
                               {"million_tests_per_second", millions_per_second}});
}

} // namespace raysteps
