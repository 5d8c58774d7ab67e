// Chapter 04: the uniform grid.
// load_scene -> build_grid -> pack -> upload -> trace -> show -> write
#include "plot_resolution.h"
#include "render/show_hits.h"
#include "structure/grid/build_grid.h"
#include "trace/live_trace.h"
#include "trace/measure_walks.h"
#include "trace/trace_picture.h"

using namespace raysteps;

namespace {

BuiltStructure grid_over(std::span<const glm::vec3> corners, const BuildRequest& request) {
    const GridOptions options = grid_options_of(request);
    auto [grid, seconds] = timed([&] { return build_grid(corners, options); });
    const std::vector<Fact> facts = facts_of(grid, corners.size() / 3, seconds);
    return {.packed = pack(std::move(grid)), .facts = facts};
}

} // namespace

int main(int argc, char** argv) {
    Options options("04_grid", "Chapter 04: rays through the cells of a uniform grid.");
    PictureOptions picture{.scene = "bunny"};
    TraceOptions tracing{.structure = "grid"};
    std::string view = "visits";
    bool measure = false;
    bool plot = false;
    add_picture_options(options, picture);
    add_trace_options(options, tracing);
    add_view_option(options, view, tracing);
    options.flag("--measure", measure, "measure the grid with and without repeated tests");
    options.excludes("--measure", {"--rays", "--window", "--structure", "--view"});
    options.flag("--plot", plot, "plot steps, tests and time against the resolution");
    options.excludes("--plot",
                     {"--rays", "--window", "--measure", "--view", "--resolution", "--density"});
    return options.run(argc, argv, [&] {
        picture.needs_camera = tracing.rays.empty();
        const Scene scene = load_scene(picture);
        const auto context = open_context(picture);
        if (plot) {
            plot_resolution(picture, tracing, scene);
            return;
        }
        if (measure) {
            measure_walks({"grid", "grid_mailbox"}, picture, tracing, scene);
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
                {{"grid", grid_over}});
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
