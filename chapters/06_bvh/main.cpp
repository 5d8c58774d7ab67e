// Chapter 06: the bounding volume hierarchy.
// load_scene -> build_bvh -> pack -> upload -> trace -> show -> write
#include "render/show_hits.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/family_bvh.h"
#include "trace/live_trace.h"
#include "trace/measure_walks.h"
#include "trace/trace_picture.h"

using namespace raysteps;

namespace {

BuiltStructure bvh_over(std::span<const glm::vec3> corners, const BuildRequest& request) {
    const BvhOptions options = bvh_options_of(request);
    const auto [bvh, seconds] = timed([&] { return build_bvh(corners, options); });
    BuiltStructure built;
    built.packed = pack(bvh, corners);
    built.facts = facts_of(measure_bvh(bvh, options), corners.size() / 3, built.packed, seconds);
    return built;
}

} // namespace

int main(int argc, char** argv) {
    Options options("06_bvh", "Chapter 06: rays through a hierarchy of boxes.");
    PictureOptions picture{.scene = "bunny"};
    TraceOptions tracing{.structure = "bvh_ordered"};
    std::string view = "visits";
    bool measure = false;
    add_picture_options(options, picture);
    add_trace_options(options, tracing);
    add_view_option(options, view, tracing);
    options.flag("--measure", measure, "measure all walks of the hierarchy, side by side");
    options.excludes("--measure", {"--rays", "--window", "--structure", "--view"});
    return options.run(argc, argv, [&] {
        picture.needs_camera = tracing.rays.empty();
        const Scene scene = load_scene(picture);
        const auto context = open_context(picture);
        if (measure) {
            measure_walks({"bvh_skip", "bvh_ordered", "bvh_parent", "bvh_stack", "bvh4"}, picture,
                          tracing, scene);
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
                {{"bvh", bvh_over}});
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
