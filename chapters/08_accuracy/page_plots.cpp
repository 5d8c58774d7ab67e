#include "page_plots.h"

#include "scatter_plot.h"
#include "verdict.h"

#include <fmt/core.h>

#include <functional>

namespace raysteps {

namespace {

// Where a method is drawn along y, and between which bounds.
using Height = std::function<std::optional<FaultRate>(const MethodSummary&)>;

std::string hint_of(const MethodSummary& method, const FaultRate& height,
                    const std::string& y_label) {
    return fmt::format("{}: {:.4g} ns ({:.4g} to {:.4g}), {} {}", method.method, method.cost.median,
                       method.cost.lowest, method.cost.highest, to_string(height), y_label);
}

std::string plot(const KnobResult& result, const std::string& y_label, const Height& height_of) {
    const std::vector<MethodSummary> methods = summarize_methods(result);
    ScatterPlot drawn{
        result.name, "ns a " + result.unit_of_cases + ", mean of the families", y_label, {}};
    bool any_differs = false;
    for (const MethodSummary& method : methods) {
        const std::optional<FaultRate> height = height_of(method);
        if (height && height->highest > 0.0) {
            drawn.points.push_back({method.method, hint_of(method, *height, y_label),
                                    method.cost.median, method.cost.lowest, method.cost.highest,
                                    height->counted, height->lowest, height->highest,
                                    is_dominated(method, methods)});
            any_differs = any_differs || height->counted != drawn.points.front().y;
        }
    }
    return any_differs ? to_svg(drawn) : "";
}

} // namespace

std::string plots_of(const KnobResult& result) {
    if (result.kind == KnobKind::speed_only) {
        return "";
    }
    return plot(result, "faults per million, worst family",
                [](const MethodSummary& method) { return method.faults; }) +
           plot(result, "error (99 %), worst family; " + result.unit_of_error,
                [](const MethodSummary& method) -> std::optional<FaultRate> {
                    if (!method.error) {
                        return std::nullopt;
                    }
                    return FaultRate{*method.error, *method.error, *method.error};
                });
}

} // namespace raysteps
