// Chapter 11: light that comes from everywhere, along paths.
// load_scene -> build -> upload -> blocks of 16 samples -> sums -> write
#include "11_paths/noise.h"
#include "11_paths/run_paths.h"

using namespace raysteps;

int main(int argc, char** argv) {
    Options options("11_paths", "Chapter 11: light that comes from everywhere, along paths.");
    PictureOptions picture{.scene = "cornell_box", .size = {128, 128}};
    TraceOptions tracing{.structure = "fastest"};
    PathOptions paths;
    NoiseRequest noise;
    add_picture_options(options, picture);
    options.choice("--structure", tracing.structure, "what the rays walk through",
                   structure_names());
    options.choice("--triangle", tracing.triangle, "the triangle test", part_names("triangle"));
    add_build_options(options, tracing.build_values);
    add_path_options(options, paths);
    add_noise_options(options, noise);
    for (const std::string option : {"--jobs-file", "--merge"}) {
        options.excludes(option, {"--window", "--seconds", "--error", "--noise"});
    }
    options.excludes("--merge", {"--samples", "--json"});
    options.excludes("--noise", {"--window", "--seconds", "--json"});
    return options.run(argc, argv, [&] {
        if (!paths.jobs.file.empty()) {
            write_path_jobs(paths, words_without(argc, argv,
                                                 {"--jobs-file", "--results", "--samples",
                                                  "--samples-per-part", "--out", "--json"}));
            return;
        }
        if (!paths.jobs.merge.empty()) {
            merge_paths(picture, paths);
            return;
        }
        const Scene scene = load_scene(picture);
        const auto context = open_context(picture);
        if (noise.measure) {
            measure_noise(picture, tracing, paths, noise, scene);
            return;
        }
        render_paths(picture, tracing, paths, *context, scene);
    });
}
