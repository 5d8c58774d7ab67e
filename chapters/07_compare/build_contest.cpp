#include "build_contest.h"

#include "basics/error.h"
#include "basics/text.h"
#include "measure/stopwatch.h"
#include "reference/embree/embree.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/bvh.h"
#include "structure/bvh/family_bvh.h"

#include <fmt/core.h>

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
    const double nanoseconds = 1e9 / static_cast<double>(triangles);
    std::vector<double> ours;
    std::vector<double> embrees;
    for (int round = 0; round <= rounds; ++round) {
        progress(static_cast<double>(round) / (rounds + 2));
        const double own = seconds_of([&] { build_bvh(scene.corners, options); }).cpu;
        embree.prepare();
        const double embrees_own = seconds_of([&] { embree.build(); }).cpu;
        if (round > 0) {
            ours.push_back(own * nanoseconds);
            embrees.push_back(embrees_own * nanoseconds);
        }
    }
    BvhOptions sweep = options;
    sweep.split = BvhSplit::sweep;
    const double cost = cost_of(scene, options) / cost_of(scene, sweep);
    progress(1.0);
    return {scene.name, triangles, measured_range(ours), measured_range(embrees), cost};
}

std::string to_table(const std::vector<BuildContest>& contests) {
    std::string table =
        fmt::format("{:16} {:>10} {:>20} {:>20} {:>6} {:>8}\n", "scene", "triangles",
                    "ours, ns a triangle", "rtcBuildBVH", "ratio", "cost");
    for (const BuildContest& contest : contests) {
        table += fmt::format("{:16} {:10} {:>20} {:>20} {:6.2f} {:8.4f}\n", contest.scene,
                             contest.triangles, to_words(contest.ours), to_words(contest.embrees),
                             ratio_of(contest), contest.cost_to_sweep);
    }
    return table;
}

std::string to_csv(const std::vector<BuildContest>& contests) {
    std::string csv = "scene,triangles,nanoseconds_a_triangle,embree_nanoseconds_a_triangle,"
                      "ratio,cost_to_sweep\n";
    for (const BuildContest& contest : contests) {
        csv += csv_field(contest.scene) + fmt::format(",{},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                                                      contest.triangles, contest.ours.median,
                                                      contest.embrees.median, ratio_of(contest),
                                                      contest.cost_to_sweep);
    }
    return csv;
}

} // namespace raysteps
