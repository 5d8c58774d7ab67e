// Chapter 07: all structures and all walks in one run, and Embree beside them.
#include "builds.h"
#include "render/show_hits.h"
#include "run_comparison.h"
#include "trace/trace_picture.h"

using namespace raysteps;

namespace {

void show_normals(const PictureOptions& picture, const TraceOptions& tracing) {
    const Scene scene = load_scene(picture);
    const auto context = open_context(picture);
    const BuiltStructure built =
        build_structure(tracing.structure, scene.corners,
                        {.reach = camera_reach(picture, scene), .values = tracing.build_values});
    const SceneTextures textures = upload(scene, built);
    TraceRays trace(trace_parts(tracing.triangle, tracing.structure), measure_limits());
    show_or_write(
        picture, *context, scene.camera, picture_name(picture.scene),
        [&](const Camera& camera, int width, int height) {
            const RayTextures rays = generate_rays(camera, width, height, RayGeneration::direct);
            const Texture hits = trace.closest_hits(rays, textures);
            return show_hits(rays, hits, textures, camera, scene.background, "view/normals.glsl");
        });
}

} // namespace

int main(int argc, char** argv) {
    Options options("07_compare",
                    "Chapter 07: which structure is the fastest? All of them in one run.");
    PictureOptions picture{.scene = "bunny", .size = {128, 128}};
    TraceOptions tracing{.structure = "fastest"};
    Comparison comparison;
    bool builds = false;
    add_picture_options(options, picture);
    add_trace_options(options, tracing);
    options.list("--scenes", comparison.scenes,
                 "the scenes to compare in: names and files between commas");
    options.number("--growth", comparison.growth,
                   "the largest sphereflake of the series 0, 1, 2 ... that shows growth: 5 has 5 "
                   "million triangles; -1: no series",
                   -1, 5);
    options.number("--rounds", comparison.rounds, "how often each trace is measured", 1, 1000);
    options.number("--most-seconds", comparison.most_seconds,
                   "the most that one trace may take: a slower walk is measured with fewer rays",
                   1e-9, 1e9);
    options.text("--embree", comparison.embree, "auto, robust, fast or off");
    options.flag("--builds", builds, "only build: our BVH and Embree's, in turn, on one thread");
    return options.run(argc, argv, [&] {
        if (!tracing.rays.empty()) {
            const Scene scene = load_scene(picture);
            const auto context = open_context(picture);
            trace_ray_file(picture, tracing, scene);
            return;
        }
        if (picture.window) {
            show_normals(picture, tracing);
            return;
        }
        comparison.embree_part = parse_embree(comparison.embree);
        if (options.given("--scene")) { // one scene of the person's own, and nothing else
            if (!options.given("--scenes")) {
                comparison.scenes.clear();
            }
            comparison.scenes.insert(comparison.scenes.begin(), picture.scene);
            comparison.growth = options.given("--growth") ? comparison.growth : -1;
        }
        if (builds) {
            run_builds(picture, tracing, comparison);
            return;
        }
        if (options.given("--structure")) {
            comparison.structures = {tracing.structure};
        }
        run_comparison(picture, tracing, comparison);
    });
}
