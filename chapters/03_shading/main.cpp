// Chapter 03: a picture as a wavefront of passes, with light, hard shadows and mirrors.
// load_scene -> upload -> passes -> write
#include "render/whitted_renderer.h"
#include "trace/trace_picture.h"

#include <cstdio>
#include <tuple>

using namespace raysteps;

int main(int argc, char** argv) {
    Options options("03_shading",
                    "Chapter 03: diffuse light, hard shadows and mirrors, pass by pass.");
    PictureOptions picture{.scene = "mirrors"};
    TraceOptions tracing;
    int max_bounces = 8;
    add_picture_options(options, picture);
    add_trace_options(options, tracing);
    options.number("--max-bounces", max_bounces, "how many mirrors a path is followed to", 0, 1000);
    return options.run(argc, argv, [&] {
        const Scene scene = load_scene(picture);
        const auto context = open_context(picture);
        if (!tracing.rays.empty()) {
            trace_ray_file(picture, tracing, scene);
            return;
        }
        const BuiltStructure built = build_structure(
            tracing.structure, scene.corners,
            {.reach = camera_reach(picture, scene), .values = tracing.build_values});
        WhittedRenderer renderer(scene, upload(scene, built),
                                 trace_parts(tracing.triangle, tracing.structure),
                                 measure_limits());
        renderer.report_progress(show_progress("tracing"));
        double seconds = 0.0;
        show_or_write(picture, *context, scene.camera, picture_name(picture.scene),
                      [&](const Camera& camera, int width, int height) {
                          Image image;
                          std::tie(image, seconds) = timed(
                              [&] { return renderer.render(camera, width, height, max_bounces); });
                          return image;
                      });
        const RayCounts& rays = renderer.ray_counts();
        std::printf("rays      %ld camera, %ld shadow, %ld mirror, in %.2f s\n", rays.camera,
                    rays.shadow, rays.mirror, seconds);
        if (!picture.json.empty()) {
            write_figures(
                picture.json, head_of("shading.schema.json", tracing, scene),
                {{"structure", tracing.structure},
                 {"triangle", tracing.triangle},
                 {"rays_by_kind",
                  {{"primary", rays.camera}, {"shadow", rays.shadow}, {"mirror", rays.mirror}}},
                 {"seconds", seconds}});
        }
    });
}
