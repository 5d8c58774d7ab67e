// Chapter 07: all structures and all walks in one run, and Embree beside them.
#include "basics/error.h"
#include "basics/text.h"
#include "builds.h"
#include "gpu_cards.h"
#include "render/show_hits.h"
#include "run_comparison.h"
#include "trace/trace_picture.h"

#include <algorithm>

using namespace raysteps;

namespace {

std::vector<StructureChoice> parse_structures(const std::string& text) {
    std::vector<StructureChoice> structures;
    for (const std::string& word : split_words(text, ',')) {
        walk_parts("watertight",
                   word.substr(0, word.find(':'))); // which names those that there are
        structures.push_back(parse_structure(word));
        const auto same = [&](const StructureChoice& one) { return one.text == word; };
        if (std::ranges::count_if(structures, same) > 1) {
            throw InputError("--structure " + text + ": " + word +
                             " is named twice. Give one of the two other options, or leave it "
                             "out.");
        }
    }
    return structures;
}

// What traces a file of rays or fills a window is one walk.
void take_only_structure(const std::vector<StructureChoice>& structures, TraceOptions& tracing) {
    if (structures.size() > 1) {
        throw InputError("--structure: rays of a file and of a window go through one structure. "
                         "Name one.");
    }
    tracing.structure = structures.front().structure;
    for (const auto& [name, value] : structures.front().values) {
        tracing.build_values[name] = value;
    }
}

void show_normals(const PictureOptions& picture, const TraceOptions& tracing) {
    const Scene scene = load_scene(picture);
    const auto context = open_context(picture);
    BuiltStructure built =
        build_structure(tracing.structure, scene.corners,
                        {.reach = camera_reach(picture, scene), .values = tracing.build_values});
    const SceneTextures textures = upload(scene, std::move(built));
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
    std::filesystem::path gpu_cards;
    add_picture_options(options, picture);
    options.value("--structure", "",
                  "only these, between commas; each may have options of its builder for itself, as "
                  "in bvh_ordered,bvh_ordered:split=median:bins=8 (default: twelve walks)",
                  [&](const std::string& text) { comparison.structures = parse_structures(text); });
    add_walk_options(options, tracing);
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
    options.input_file(
        "--against", comparison.against,
        "the --json file of an earlier run to compare with: exit code 1 where a walk "
        "is slower than then beyond doubt");
    options.input_file("--gpu-cards", gpu_cards,
                       "only the table of the files in this folder that readers of the playground "
                       "saved under Your GPU");
    options.excludes("--against", {"--rays", "--window", "--builds"});
    options.excludes("--gpu-cards", {"--rays", "--window", "--builds", "--against", "--structure"});
    options.excludes("--builds", {"--structure"});
    add_job_options(options, comparison.jobs);
    for (const std::string option : {"--jobs-file", "--merge"}) {
        options.excludes(option, {"--rays", "--window", "--builds", "--against", "--gpu-cards"});
    }
    return options.run(argc, argv, [&] {
        if (!gpu_cards.empty()) {
            print_gpu_cards(gpu_cards);
            return;
        }
        if (options.given("--structure") && (picture.window || !tracing.rays.empty())) {
            take_only_structure(comparison.structures, tracing);
        }
        if (!tracing.rays.empty()) {
            picture.needs_camera = false;
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
        if (!comparison.jobs.file.empty()) {
            write_comparison_jobs(comparison,
                                  words_without(argc, argv,
                                                {"--jobs-file", "--results", "--scene", "--scenes",
                                                 "--growth", "--out", "--json"}));
            return;
        }
        if (!comparison.jobs.merge.empty()) {
            merge_comparison(picture, comparison);
            return;
        }
        if (builds) {
            run_builds(picture, tracing, comparison);
            return;
        }
        run_comparison(picture, tracing, comparison);
    });
}
