#include "tables.h"

#include "basics/text.h"

#include <fmt/core.h>

namespace raysteps {

namespace {

const ContestBuild& build_of(const SceneResult& result, const std::string& contender) {
    static const ContestBuild unknown{};
    for (const ContestBuild& build : result.builds) {
        if (build.contender == contender) {
            return build;
        }
    }
    return unknown;
}

} // namespace

std::string to_table(const SceneResult& result) {
    std::string table = fmt::format("\n{}, {} triangle{}\n", result.scene, result.triangles,
                                    result.triangles == 1 ? "" : "s");
    table += "contender             build s    MB\n";
    for (const ContestBuild& build : result.builds) {
        table += fmt::format("{:21} {:7.3f} {:5.1f}\n", build.contender,
                             fact_of(build, "build_seconds"), fact_of(build, "memory_bytes") / 1e6);
    }
    table += "contender             rays             visits    tests  Mrays/s (range)          "
             "cores  other answers\n";
    bool any_sampled = false;
    for (const ContestRow& row : result.rows) {
        const bool sampled = row.rays < row.all_rays;
        any_sampled = any_sampled || sampled;
        const std::string counts =
            is_embree(row.contender)
                ? "       -        -"
                : fmt::format("{:8.1f} {:8.2f}", row.visits_a_ray, row.tests_a_ray);
        table += fmt::format("{:21} {:10} {:7}{} {}  {:<7.3g} ({:.3g} to {:.3g})  {:5.2f}  {}\n",
                             row.contender, row.kind, row.rays, sampled ? "*" : " ", counts,
                             row.rate.median, row.rate.lowest, row.rate.highest, row.cores,
                             row.different);
    }
    if (any_sampled) {
        table += "* too slow for all rays in the time there is: runs of 64, from all over.\n";
    }
    return table;
}

std::string to_csv(std::span<const SceneResult> results) {
    std::string csv = "scene,triangles,contender,rays,count,of,visits_a_ray,tests_a_ray,"
                      "million_rays_a_second,lowest,highest,cores,build_seconds,memory_bytes,"
                      "other_answers\n";
    for (const SceneResult& result : results) {
        for (const ContestRow& row : result.rows) {
            const ContestBuild& build = build_of(result, row.contender);
            csv +=
                csv_field(result.scene) +
                fmt::format(
                    ",{},{},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.12g},{}\n",
                    result.triangles, row.contender, row.kind, row.rays, row.all_rays,
                    row.visits_a_ray, row.tests_a_ray, row.rate.median, row.rate.lowest,
                    row.rate.highest, row.cores, fact_of(build, "build_seconds"),
                    fact_of(build, "memory_bytes"), row.different);
        }
    }
    return csv;
}

std::string to_table(std::span<const ClaimResult> claims) {
    std::string table;
    for (const ClaimResult& claim : claims) {
        table += "\"" + claim.claim + "\", " + claim.kind + ": " + to_words(claim.verdict) + "\n";
        for (const ClaimCase& one : claim.cases) {
            table += fmt::format("    {:16} {:15} ", one.scene, to_words(one.verdict)) +
                     one.numbers + "\n";
        }
    }
    return table;
}

} // namespace raysteps
