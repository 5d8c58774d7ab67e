#include "run_builds.h"

#include "program/progress.h"
#include "program/tracing_options.h"
#include "build_contest.h"
#include "reference/embree/embree.h"
#include "basics/error.h"
#include "basics/file.h"

#include <iostream>

namespace raysteps {

void run_builds(const Command& command, const Comparison& comparison) {
    if (embree_name().empty()) {
        throw MachineError("--builds: this program was built without Embree. Install the package "
                           "libembree-dev, and build again.");
    }
    std::vector<BuildContest> contests;
    for (const std::string& name : comparison.scenes) {
        Command own = command;
        own.scene = name;
        const Scene scene = open_scene(own);
        contests.push_back(contest_builds(scene, {.values = command.build_values},
                                          comparison.rounds, show_progress("building " + name)));
    }
    std::cout << "A BVH by our builder and by " << embree_name()
              << ", one thread each: time of the processor in the middle of " << comparison.rounds
              << " rounds, and its range\n"
              << to_table(contests)
              << "(cost: what a ray is expected to cost, over that of a full sweep)\n";
    const std::filesystem::path path = command.out / "builds.csv";
    write_file(path, to_csv(contests));
    std::cout << "wrote     " << path.string() << "\n";
}

} // namespace raysteps
