#include "builds.h"

#include "basics/error.h"
#include "basics/text.h"
#include "measure/built_structures.h"
#include "measure/contest.h"
#include "program/figures.h"
#include "reference/embree/embree.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/bvh.h"
#include "structure/bvh/family_bvh.h"

#include <fmt/core.h>

#include <iostream>

namespace raysteps {

namespace {

std::vector<Box> boxes_of(std::span<const glm::vec3> corners) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        boxes.push_back(bounds_of(corners.subspan(i, 3)));
    }
    return boxes;
}

double cost_of(const Scene& scene, const BvhOptions& options) {
    return measure_bvh(build_bvh(scene.corners, options), options).cost;
}

std::string to_words(const MeasuredRange& range) {
    return fmt::format("{:5.0f} ({:.0f}-{:.0f})", range.median, range.lowest, range.highest);
}

double ratio_of(const BuildContest& contest) {
    return contest.ours.median / contest.embrees.median;
}

Numbers numbers_of(const MeasuredRange& nanoseconds) {
    return {{"median", nanoseconds.median},
            {"lowest", nanoseconds.lowest},
            {"highest", nanoseconds.highest}};
}

Numbers numbers_of(const std::vector<BuildContest>& contests) {
    Numbers numbers = empty_list();
    for (const BuildContest& contest : contests) {
        numbers.push_back({{"scene", contest.scene},
                           {"cpu_nanoseconds_per_triangle", numbers_of(contest.ours)},
                           {"cpu_nanoseconds_per_triangle_by_embree", numbers_of(contest.embrees)},
                           {"cost_to_sweep", contest.cost_to_sweep}});
    }
    return numbers;
}

} // namespace

BuildContest contest_builds(const Scene& scene, const BuildRequest& request, int rounds,
                            const Progress& progress) {
    const std::size_t triangles = scene.corners.size() / 3;
    if (triangles == 0) {
        throw InputError(scene.name + " has no triangle, so there is nothing to build. Take "
                                      "another scene.");
    }
    BvhOptions options = bvh_options_of(request);
    options.threads = 1;
    EmbreeBuilder embree(boxes_of(scene.corners), {options.leaf_triangles, options.traversal_cost,
                                                   options.intersection_cost});
    const std::vector<Contender> contenders{
        {.name = "ours", .run = [&] { build_bvh(scene.corners, options); }},
        {.name = "Embree", .run = [&] { embree.build(); }, .prepare = [&] { embree.prepare(); }}};
    const std::vector<ContestTimes> times =
        run_contest(contenders, rounds, [&](double part_done) { progress(0.9 * part_done); });
    const auto nanoseconds_per_triangle = [&](const Seconds& seconds) {
        return seconds.cpu * 1e9 / static_cast<double>(triangles);
    };
    BvhOptions sweep = options;
    sweep.split = BvhSplit::sweep;
    const double cost = cost_of(scene, options) / cost_of(scene, sweep);
    progress(1.0);
    return {scene.name, triangles, over_rounds(times[0], nanoseconds_per_triangle),
            over_rounds(times[1], nanoseconds_per_triangle), cost};
}

std::string to_table(const std::vector<BuildContest>& contests) {
    std::string table =
        fmt::format("{:16} {:>10} {:>20} {:>20} {:>6} {:>8}\n", "scene", "triangles",
                    "ours, ns/triangle", "rtcBuildBVH", "ratio", "cost");
    for (const BuildContest& contest : contests) {
        table += fmt::format("{:16} {:10} {:>20} {:>20} {:6.2f} {:8.4f}\n", contest.scene,
                             contest.triangles, to_words(contest.ours), to_words(contest.embrees),
                             ratio_of(contest), contest.cost_to_sweep);
    }
    return table;
}

std::string to_csv(const std::vector<BuildContest>& contests) {
    std::string csv = "scene,triangles,nanoseconds_per_triangle,embree_nanoseconds_per_triangle,"
                      "ratio,cost_to_sweep\n";
    for (const BuildContest& contest : contests) {
        csv += csv_field(contest.scene) + fmt::format(",{},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                                                      contest.triangles, contest.ours.median,
                                                      contest.embrees.median, ratio_of(contest),
                                                      contest.cost_to_sweep);
    }
    return csv;
}

void run_builds(const PictureOptions& picture, const TraceOptions& tracing,
                const Comparison& comparison) {
    if (embree_name().empty()) {
        throw MachineError("--builds: this program was built without Embree. Install the package "
                           "libembree-dev, and build again.");
    }
    std::vector<BuildContest> contests;
    FiguresHead head{.schema = "builds.schema.json",
                     .builders = used_builders(plain_structures({"bvh"}), tracing.build_values)};
    for (const std::string& name : comparison.scenes) {
        const Scene scene = load_scene(picture, name);
        head.scenes.push_back(record_of(scene));
        contests.push_back(contest_builds(scene, {.values = tracing.build_values},
                                          comparison.rounds, show_progress("building " + name)));
    }
    std::cout << "A BVH by our builder and by " << embree_name()
              << ", one thread each: median processor time of " << comparison.rounds
              << " rounds, and its range\n"
              << to_table(contests) << "(cost: expected cost per ray, over that of a full sweep)\n";
    write_text(picture.out / "builds.csv", to_csv(contests));
    write_figures(picture.json, head,
                  {{"rounds", comparison.rounds},
                   {"embree", embree_name()},
                   {"scenes", numbers_of(contests)}});
}

} // namespace raysteps
