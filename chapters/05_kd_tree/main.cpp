// Chapter 05: the kd-tree, walked without a stack.
// load_scene -> build_kd_tree -> pack -> upload -> trace -> show -> write
#include "render/show_hits.h"
#include "structure/kd_tree/build_kd_tree.h"
#include "trace/live_trace.h"
#include "trace/measure_walks.h"
#include "trace/trace_picture.h"

using namespace raysteps;

namespace {

BuiltStructure kd_tree_over(std::span<const glm::vec3> corners, const BuildRequest& request) {
    const KdOptions options = kd_options_of(request);
    const auto [tree, seconds] = timed([&] { return build_kd_tree(corners, options); });
    return {.packed = pack(tree), .facts = facts_of(tree, options, corners.size() / 3, seconds)};
}

} // namespace

int main(int argc, char** argv) {
    Options options("05_kd_tree",
                    "Chapter 05: rays through a kd-tree, in four ways without a full stack.");
    PictureOptions picture{.scene = "bunny"};
    TraceOptions tracing{.structure = "kd_restart"};
    std::string view = "visits";
    bool measure = false;
    add_picture_options(options, picture);
    add_trace_options(options, tracing);
    add_view_option(options, view, tracing);
    options.flag("--measure", measure, "measure all four walks, and the grid beside them");
    options.excludes("--measure", {"--rays", "--window", "--structure", "--view"});
    return options.run(argc, argv, [&] {
        picture.needs_camera = tracing.rays.empty();
        const Scene scene = load_scene(picture);
        const auto context = open_context(picture);
        if (measure) {
            measure_walks({"grid", "kd_restart", "kd_backtrack", "kd_short_stack", "kd_ropes"},
                          picture, tracing, scene);
            return;
        }
        if (!tracing.rays.empty()) {
            trace_ray_file(picture, tracing, scene);
            return;
        }
        const Limits limits = measure_limits();
        std::optional<SceneTextures> textures;
        std::optional<TraceRays> trace;
        const auto make = [&] {
            TraceRays walk(trace_parts(tracing.triangle, tracing.structure, view), limits);
            BuiltStructure built = build_structure(
                tracing.structure, scene.corners,
                {.reach = camera_reach(picture, scene), .values = tracing.build_values},
                {{"kd", kd_tree_over}});
            textures = upload(scene, std::move(built));
            trace = std::move(walk);
            trace->report_progress(show_progress("tracing"));
        };
        make();
        TraceTime time;
        const std::string name = picture_name(picture.scene) + "_" + tracing.structure + "_" + view;
        show_or_write(
            picture, *context, scene.camera, name,
            [&](const Camera& camera, int width, int height) {
                const RayTextures rays =
                    generate_rays(camera, width, height, RayGeneration::direct);
                const auto [hits, seconds] =
                    timed([&] { return trace->closest_hits(rays, *textures); });
                time = {static_cast<double>(width) * height, seconds};
                return is_heat_map(view)
                           ? show_work(*trace->observations(), view, tracing.structure)
                           : show_hits(rays, hits, *textures, camera, scene.background,
                                       find_part("view", view));
            },
            live_trace(picture, scene, tracing, view, make));
        report_trace(picture, tracing, scene, *textures, time);
    });
}
