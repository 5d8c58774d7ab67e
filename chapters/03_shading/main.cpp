// Chapter 03: a picture as a wavefront of passes, with light, hard shadows and mirrors.
#include "program/command.h"
#include "program/deliver.h"
#include "program/progress.h"
#include "program/timed_trace.h"
#include "program/tracing_options.h"
#include "render/whitted_renderer.h"

#include <chrono>
#include <cstdio>

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Chapter 03: diffuse light, hard shadows and mirrors, pass by pass.");
    Command command{.chapter = "03_shading", .scene = "mirrors"};
    int max_bounces = 8;
    add_common_options(app, command);
    add_tracing_options(app, command);
    app.add_option("--max-bounces", max_bounces,
                   "how many mirrors a path is followed to, 0 to 1000")
        ->capture_default_str()
        ->check(CLI::Range(0, 1000));
    return run_command(app, command, argc, argv, [&] {
        const Parts parts = trace_parts(command);
        const Scene scene = open_scene(command);
        const auto context = open_context(command);
        if (!command.rays.empty()) {
            trace_ray_file(command, parts, scene);
            return;
        }
        WhittedRenderer renderer(scene, upload(scene, build_structure(command, scene)), parts,
                                 measure_limits());
        renderer.report_progress(show_progress("tracing"));
        double seconds = 0.0;
        deliver(
            command, *context, scene.camera, picture_name(command),
            [&](const Camera& camera, int width, int height) {
                const auto start = std::chrono::steady_clock::now();
                Image image = renderer.render(camera, width, height, max_bounces);
                seconds =
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
                return image;
            });
        const RayCounts& rays = renderer.ray_counts();
        std::printf("rays      %ld camera, %ld shadow, %ld mirror, in %.2f s\n", rays.camera,
                    rays.shadow, rays.mirror, seconds);
        deliver_numbers(command, {{"scene", command.scene},
                                  {"renderer", renderer_name()},
                                  {"camera_rays", rays.camera},
                                  {"shadow_rays", rays.shadow},
                                  {"mirror_rays", rays.mirror},
                                  {"seconds", seconds}});
    });
}
