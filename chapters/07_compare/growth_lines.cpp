#include "growth_lines.h"

#include <fmt/core.h>

#include <algorithm>

namespace raysteps {

namespace {

void add_point(std::vector<GrowthLine>& lines, const std::string& contender,
               const std::string& cost, const GrowthPoint& point) {
    if (!(point.cost > 0.0)) { // nobody measured it
        return;
    }
    auto line = std::find_if(lines.begin(), lines.end(), [&](const GrowthLine& known) {
        return known.contender == contender && known.cost == cost;
    });
    if (line == lines.end()) {
        line = lines.insert(lines.end(), {contender, cost, {}, 0.0});
    }
    line->points.push_back(point);
}

} // namespace

std::vector<GrowthLine> growth_lines(std::span<const SceneResult> results,
                                     const std::string& series) {
    std::vector<GrowthLine> lines;
    for (const SceneResult& result : results) {
        if (!result.scene.starts_with(series + ":")) {
            continue;
        }
        const double triangles = result.triangles;
        for (const ContestRow& row : result.rows) {
            add_point(lines, row.contender, row.kind, {triangles, 1000.0 / row.rate.median});
        }
        for (const ContestBuild& build : result.builds) {
            for (const std::string fact : {"build_seconds", "memory_bytes"}) {
                add_point(lines, build.contender, fact, {triangles, fact_of(build, fact)});
            }
        }
    }
    std::erase_if(lines, [](const GrowthLine& line) {
        return std::all_of(line.points.begin(), line.points.end(), [&](const GrowthPoint& point) {
            return point.triangles == line.points.front().triangles;
        });
    });
    for (GrowthLine& line : lines) {
        line.exponent = growth_exponent(line.points);
    }
    return lines;
}

std::string to_table(std::span<const GrowthLine> lines) {
    if (lines.empty()) {
        return "";
    }
    std::string table = "\nHow costs grow: cost = c * triangles^k\n";
    for (const GrowthLine& line : lines) {
        table += fmt::format("{:21} {:13} k = {:5.2f}  ({:.0f} to {:.0f} triangles)\n",
                             line.contender, line.cost, line.exponent,
                             line.points.front().triangles, line.points.back().triangles);
    }
    return table;
}

} // namespace raysteps
