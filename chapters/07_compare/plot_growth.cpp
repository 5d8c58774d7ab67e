#include "plot_growth.h"

#include "report/plot.h"

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

PlotLine plot_line(const GrowthLine& line) {
    char exponent[32];
    std::snprintf(exponent, sizeof exponent, ", k = %.2f", line.exponent);
    PlotLine drawn{line.contender + exponent, {}};
    for (const GrowthPoint& point : line.points) {
        drawn.points.push_back({point.triangles, point.cost});
    }
    return drawn;
}

} // namespace

void plot_growth(const Command& command, std::span<const GrowthLine> lines) {
    std::map<std::string, std::vector<PlotLine>> by_cost;
    for (const GrowthLine& line : lines) {
        by_cost[line.cost].push_back(plot_line(line));
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
