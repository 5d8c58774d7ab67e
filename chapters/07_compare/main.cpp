// Chapter 07: all structures and all walks in one run, and Embree beside them.
#include "builds.h"
#include "program/command.h"
#include "program/show_trace.h"
#include "program/tracing_options.h"
#include "run_comparison.h"

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Chapter 07: which structure is the fastest? All of them in one run.");
    Command command{.chapter = "07_compare", .scene = "bunny", .size = "128x128"};
    command.structure = "bvh_ordered";
    Comparison comparison;
    add_common_options(app, command);
    add_tracing_options(app, command);
    auto* scenes = app.add_option("--scenes", comparison.scenes,
                                  "the scenes to compare in: names and files between commas");
    scenes->delimiter(',')->capture_default_str();
    auto* growth = app.add_option("--growth", comparison.growth,
                                  "the largest sphereflake of the series 0, 1, 2 ... that shows "
                                  "growth: 5 has 5 million triangles; -1: no series");
    growth->check(CLI::Range(-1, 5))->capture_default_str();
    app.add_option("--rounds", comparison.rounds, "how often each trace is measured")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--most-seconds", comparison.most_seconds,
                   "of one trace: a slower walk is measured with fewer rays")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--embree", comparison.embree, "auto, robust, fast or off")
        ->capture_default_str();
    bool builds = false;
    app.add_flag("--builds", builds, "only build: our BVH and Embree's, in turn, on one thread");
    return run_command(app, command, argc, argv, [&] {
        if (!command.rays.empty() || command.window) {
            show_trace(command, "normals");
            return;
        }
        comparison.embree_part = parse_embree(comparison.embree);
        if (app.count("--scene") > 0) { // one scene of the person's own, and nothing else
            if (scenes->count() == 0) {
                comparison.scenes.clear();
            }
            comparison.scenes.insert(comparison.scenes.begin(), command.scene);
            comparison.growth = growth->count() > 0 ? comparison.growth : -1;
        }
        if (builds) {
            run_builds(command, comparison);
            return;
        }
        if (app.count("--structure") > 0) {
            comparison.structures = {command.structure};
        }
        run_comparison(command, comparison);
    });
}
