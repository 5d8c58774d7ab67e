// Chapter 03: a picture as a wavefront of passes, with light, hard shadows and mirrors.
// load_scene -> upload -> passes -> write
#include "render/whitted_renderer.h"
#include "trace/live_trace.h"
#include "trace/trace_picture.h"

#include <cstdio>
#include <tuple>

using namespace raysteps;

namespace {

// With fewer triangles the loop over all of them takes seconds, and nobody asks.
constexpr int many_triangles = 20000;

// The loop is this chapter's lesson. Before it begins over a large model, it says how long that
// will take: by the rate at which this machine tests the first of the triangles, with enough rays
// for all its processors.
void announce_loop(const PictureOptions& picture, const TraceOptions& tracing, const Scene& scene,
                   const Limits& limits) {
    const int triangles = triangle_count(scene);
    if (tracing.structure != "every_triangle" || triangles <= many_triangles) {
        return;
    }
    const SceneTextures first_ones = upload(scene, every_triangle(many_triangles));
    TraceRays trace(trace_parts(tracing.triangle, tracing.structure), limits);
    const RayTextures rays = generate_rays(scene.camera, 512, 8, RayGeneration::direct);
    trace.closest_hits(rays, first_ones); // some drivers compile at the first call
    const double seconds = timed([&] { return trace.closest_hits(rays, first_ones); }).second;
    const double seconds_per_test = seconds / (512.0 * 8.0 * many_triangles);
    const double pixels = static_cast<double>(picture.size.width) * picture.size.height;
    std::printf("loop      %d triangles for each ray: about %.0f s for the camera's rays, up to as "
                "much for each light, and more for mirrors. Quick: --structure fastest\n",
                triangles, pixels * triangles * seconds_per_test);
    std::fflush(stdout);
}

std::string in_words(const RayCounts& rays) {
    return std::to_string(rays.camera) + " camera, " + std::to_string(rays.shadow) + " shadow, " +
           std::to_string(rays.mirror) + " mirror";
}

} // namespace

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
        picture.needs_camera = tracing.rays.empty();
        const Scene scene = load_scene(picture);
        const auto context = open_context(picture);
        if (!tracing.rays.empty()) {
            trace_ray_file(picture, tracing, scene);
            return;
        }
        const Limits limits = measure_limits();
        std::optional<WhittedRenderer> renderer;
        const auto make = [&] {
            BuiltStructure built = build_structure(
                tracing.structure, scene.corners,
                {.reach = camera_reach(picture, scene), .values = tracing.build_values});
            renderer = WhittedRenderer(scene, upload(scene, std::move(built)),
                                       trace_parts(tracing.triangle, tracing.structure), limits);
            renderer->report_progress(show_progress("tracing"));
        };
        make();
        announce_loop(picture, tracing, scene, limits);
        LiveOffer live = live_trace(picture, scene, tracing, make);
        live.choices.push_back(
            number_choice("mirrors", 'm', {0, 1, 2, 4, 8, 16}, max_bounces, [] {}));
        live.notes = [&] { return std::vector{in_words(renderer->ray_counts())}; };
        double seconds = 0.0;
        show_or_write(
            picture, *context, scene.camera, picture_name(picture.scene),
            [&](const Camera& camera, int width, int height) {
                Image image;
                std::tie(image, seconds) =
                    timed([&] { return renderer->render(camera, width, height, max_bounces); });
                return image;
            },
            live);
        const RayCounts& rays = renderer->ray_counts();
        std::printf("rays      %s, in %.2f s\n", in_words(rays).c_str(), seconds);
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
