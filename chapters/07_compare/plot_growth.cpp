#include "plot_growth.h"

#include "image/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <iostream>
#include <map>

namespace raysteps {

namespace {

std::string label_of(const std::string& cost) {
    if (cost == "build_seconds") {
        return "seconds to build";
    }
    return cost == "memory_bytes" ? "bytes" : "nanoseconds a " + cost + " ray";
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
    return shared ? line.contender.substr(0, line.contender.find_first_of("_ ")) : line.contender;
}

PlotLine plot_line(const GrowthLine& line, const std::string& name) {
    PlotLine drawn{fmt::format("{}, k = {:.2f}", name, line.exponent), {}};
    for (const GrowthPoint& point : line.points) {
        drawn.points.push_back({point.triangles, point.cost});
    }
    return drawn;
}

} // namespace

void plot_growth(const Command& command, std::span<const GrowthLine> lines) {
    std::map<std::string, std::vector<PlotLine>> by_cost;
    for (auto line = lines.begin(); line != lines.end(); ++line) {
        const auto is_same = [&](const GrowthLine& other) { return same_points(*line, other); };
        if (std::none_of(lines.begin(), line, is_same)) {
            by_cost[line->cost].push_back(plot_line(*line, name_of(*line, lines)));
        }
    }
    for (const auto& [cost, drawn] : by_cost) {
        const std::filesystem::path path = command.out / ("growth_" + cost + ".png");
        write_plot(path, {.title = "Sphereflakes of growing size",
                          .x_label = "triangles",
                          .y_label = label_of(cost),
                          .x_scale = PlotScale::logarithmic,
                          .y_scale = PlotScale::logarithmic,
                          .lines = drawn});
        std::cout << "wrote     " << path.string() << "\n";
    }
}

} // namespace raysteps
