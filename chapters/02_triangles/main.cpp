// Chapter 02: the loop over every triangle.
#include "program/command.h"
#include "program/deliver.h"
#include "program/timed_trace.h"
#include "program/tracing_options.h"
#include "exhibit.h"
#include "gpu/shaders.h"
#include "render/rays.h"
#include "render/show_hits.h"

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Chapter 02: rays and triangles, one by one.");
    Command command{.chapter = "02_triangles", .scene = "knot:2"};
    std::string view = "normals";
    bool exhibit = false;
    add_common_options(app, command);
    add_tracing_options(app, command);
    app.add_option("--view", view, "normals, facets, depth, hits, triangles or barycentric")
        ->capture_default_str();
    app.add_flag("--exhibit", exhibit, "compare the paper's listing, as printed and repaired")
        ->excludes("--rays", "--window");
    return run_command(app, command, argc, argv, [&] {
        const Parts parts = trace_parts(command);
        const std::string view_part = find_part("view", view);
        const Scene scene = open_scene(command);
        const auto context = open_context(command);
        if (exhibit) {
            show_exhibit(command, scene);
            return;
        }
        if (!command.rays.empty()) {
            trace_ray_file(command, parts, scene);
            return;
        }
        const SceneTextures textures = upload(scene, build_structure(command, scene));
        TimedTrace trace(command, parts, textures);
        deliver(command, *context, scene.camera, picture_name(command) + "_" + view,
                [&](const Camera& camera, int width, int height) {
                    const RayTextures rays =
                        generate_rays(camera, width, height, RayGeneration::direct);
                    const Texture hits = trace.closest_hits(
                        rays, static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
                    return show_hits(rays, hits, textures, camera, scene.background, view_part);
                });
        trace.report();
    });
}
