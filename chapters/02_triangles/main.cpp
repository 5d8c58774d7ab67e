// Chapter 02: the loop over every triangle.
// load_scene -> upload -> trace -> show -> write
#include "exhibit.h"
#include "render/show_hits.h"
#include "trace/trace_picture.h"

using namespace raysteps;

int main(int argc, char** argv) {
    Options options("02_triangles", "Chapter 02: rays and triangles, one by one.");
    PictureOptions picture{.scene = "knot:2"};
    TraceOptions tracing;
    std::string view = "normals";
    bool exhibit = false;
    add_picture_options(options, picture);
    add_trace_options(options, tracing);
    options.choice("--view", view, "what to show of the hits", part_names("view"));
    options.flag("--exhibit", exhibit, "compare the paper's listing, as printed and repaired");
    options.excludes("--exhibit", {"--rays", "--window"});
    return options.run(argc, argv, [&] {
        picture.needs_camera = tracing.rays.empty();
        const Scene scene = load_scene(picture);
        const auto context = open_context(picture);
        if (exhibit) {
            show_exhibit(scene, picture.out, picture.json);
            return;
        }
        if (!tracing.rays.empty()) {
            trace_ray_file(picture, tracing, scene);
            return;
        }
        BuiltStructure built = build_structure(
            tracing.structure, scene.corners,
            {.reach = camera_reach(picture, scene), .values = tracing.build_values});
        const SceneTextures textures = upload(scene, std::move(built));
        TraceRays trace(trace_parts(tracing.triangle, tracing.structure), measure_limits());
        trace.report_progress(show_progress("tracing"));
        TraceTime time;
        show_or_write(picture, *context, scene.camera, picture_name(picture.scene) + "_" + view,
                      [&](const Camera& camera, int width, int height) {
                          const RayTextures rays =
                              generate_rays(camera, width, height, RayGeneration::direct);
                          const auto [hits, seconds] =
                              timed([&] { return trace.closest_hits(rays, textures); });
                          time = {static_cast<double>(width) * height, seconds};
                          return show_hits(rays, hits, textures, camera, scene.background,
                                           find_part("view", view));
                      });
        report_trace(picture, tracing, scene, textures, time);
    });
}
