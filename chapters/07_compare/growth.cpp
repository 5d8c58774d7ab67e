#include "growth.h"

#include "image/plot.h"
#include "program/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

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

std::string label_of(const std::string& cost) {
    if (cost == "build_seconds") {
        return "seconds to build";
    }
    return cost == "memory_bytes" ? "bytes" : "nanoseconds per " + cost + " ray";
}

bool same_points(const GrowthLine& a, const GrowthLine& b) {
    return a.cost == b.cost &&
           std::ranges::equal(a.points, b.points, [](const auto& p, const auto& q) {
               return p.triangles == q.triangles && p.cost == q.cost;
           });
}

// Walks of one family share what they walk through, and what it cost: one line for all of them.
std::string name_of(const GrowthLine& line, std::span<const GrowthLine> lines) {
    const auto same = [&](const GrowthLine& other) { return same_points(line, other); };
    const bool shared = std::ranges::count_if(lines, same) > 1;
    if (!shared) {
        return line.contender;
    }
    const std::size_t options = line.contender.find(':');
    return line.contender.substr(0, line.contender.find_first_of("_: ")) +
           (options == std::string::npos ? "" : line.contender.substr(options));
}

PlotLine plot_line(const GrowthLine& line, const std::string& name) {
    PlotLine drawn{fmt::format("{}, k = {:.2f}", name, line.exponent), {}};
    for (const GrowthPoint& point : line.points) {
        drawn.points.push_back({point.triangles, point.cost});
    }
    return drawn;
}

} // namespace

std::vector<GrowthLine> growth_lines(std::span<const SceneCosts> results,
                                     const std::string& series) {
    std::vector<GrowthLine> lines;
    for (const SceneCosts& result : results) {
        if (!result.scene.starts_with(series + ":")) {
            continue;
        }
        const double triangles = result.triangles;
        for (const RayCosts& row : result.rays) {
            add_point(lines, row.contender, row.kind, {triangles, 1000.0 / row.rate.median});
        }
        for (const BuildCosts& build : result.builds) {
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

void plot_growth(const std::filesystem::path& folder, std::span<const GrowthLine> lines) {
    std::map<std::string, std::vector<PlotLine>> by_cost;
    for (auto line = lines.begin(); line != lines.end(); ++line) {
        const auto is_same = [&](const GrowthLine& other) { return same_points(*line, other); };
        if (std::none_of(lines.begin(), line, is_same)) {
            by_cost[line->cost].push_back(plot_line(*line, name_of(*line, lines)));
        }
    }
    for (const auto& [cost, drawn] : by_cost) {
        const std::filesystem::path path = folder / ("growth_" + cost + ".png");
        write_plot(path, {.title = "Sphereflakes of growing size",
                          .x_label = "triangles",
                          .y_label = label_of(cost),
                          .x_scale = PlotScale::logarithmic,
                          .y_scale = PlotScale::logarithmic,
                          .lines = drawn});
        print_written(path);
    }
}

} // namespace raysteps
