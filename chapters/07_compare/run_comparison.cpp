#include "run_comparison.h"

#include "program/progress.h"
#include "program/tracing_options.h"
#include "measure/contest.h"
#include "program_length.h"
#include "tables.h"
#include "reference/embree/embree.h"
#include "basics/file.h"
#include "numbers.h"
#include "plot_growth.h"

#include <iostream>

namespace raysteps {

namespace {

std::vector<std::string> scenes_of(const Comparison& comparison) {
    std::vector<std::string> scenes = comparison.scenes;
    for (int depth = 0; depth <= comparison.growth; ++depth) {
        scenes.push_back("sphereflake:" + std::to_string(depth));
    }
    return scenes;
}

// Scenes are loaded one after the other, but a wrong name is found before any work.
Scene open(Command command, const std::string& scene) {
    command.scene = scene;
    return open_scene(command);
}

std::vector<SceneResult> measure_scenes(const Command& command, const Comparison& comparison) {
    Contest contest({.structures = comparison.structures,
                     .build_values = command.build_values,
                     .triangle = command.triangle,
                     .embree = comparison.embree_part,
                     .width = command.width,
                     .height = command.height,
                     .rounds = comparison.rounds,
                     .most_seconds = comparison.most_seconds},
                    measure_limits());
    std::vector<SceneResult> results;
    for (const std::string& name : scenes_of(comparison)) {
        const Scene scene = open(command, name);
        results.push_back(contest.measure(scene, show_progress("measuring " + name)));
        std::cout << to_table(results.back()) << std::flush;
    }
    return results;
}

void write(const std::filesystem::path& path, const std::string& text) {
    write_file(path, text);
    std::cout << "wrote     " << path.string() << "\n";
}

} // namespace

void run_comparison(const Command& command, const Comparison& comparison) {
    trace_parts(command); // refuses a wrong --triangle or --structure before any work
    open(command, scenes_of(comparison).front());
    const auto context = open_context(command);
    std::cout << (comparison.embree_part != EmbreePart::none
                      ? "Embree    " + embree_name() + ", beside ours\n"
                      : "Embree    takes no part (to have it: the package libembree-dev, and "
                        "--embree auto)\n");
    Report report{.results = measure_scenes(command, comparison),
                  .claims = {},
                  .renderer = renderer_name(),
                  .embree = comparison.embree_part != EmbreePart::none ? embree_name() : ""};
    std::vector<ProgramLength> programs;
    for (const std::string& structure : comparison.structures) {
        programs.push_back(program_length(structure));
    }
    report.claims = judge_speed(report.results);
    report.claims.push_back(judge_simplicity(programs));
    report.growth = growth_lines(report.results, "sphereflake");
    std::cout << "\nThe paper's claims (Mrays/s of the fastest walk of each family)\n"
              << to_table(report.claims) << to_table(report.growth) << "\n";

    const std::string numbers = to_json(report).dump(2) + "\n";
    write(command.out / "compare.csv", to_csv(report.results));
    write(command.out / "compare.json", numbers);
    if (command.out == std::filesystem::path("out") / command.chapter) {
        write(std::filesystem::path("out") / "07" / "compare.json", numbers);
    }
    deliver_numbers(command, to_json(report));
    plot_growth(command, report.growth);
}

} // namespace raysteps
