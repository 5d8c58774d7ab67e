#include "scatter_plot.h"

#include "basics/text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raysteps {

namespace {

constexpr double width = 860.0;
constexpr double height = 440.0;
constexpr double left = 80.0;
constexpr double right = 600.0; // labels stand beyond
constexpr double top = 36.0;
constexpr double bottom = 390.0;
constexpr double label_left = 632.0;
constexpr double label_height = 19.0;

// A logarithmic axis from one place on the picture to another.
struct Axis {
    double lowest = 1.0;
    double highest = 10.0;
    double from = 0.0;
    double to = 1.0;

    double place(double value) const {
        const double share =
            std::log(std::clamp(value, lowest, highest) / lowest) / std::log(highest / lowest);
        return from + share * (to - from);
    }
};

// A little more than the values take, and half a power of ten at least.
Axis axis_over(double lowest, double highest, double from, double to) {
    const double room = std::max(1.12, std::sqrt(std::max(1.0, 2.0 * lowest / highest)));
    return {lowest / room, highest * room, from, to};
}

double least_drawn(const ScatterPoint& point) {
    return point.y > 0.0 ? std::max(point.y_lowest, 0.2 * point.y) : point.y_highest;
}

Axis x_axis(const ScatterPlot& plot) {
    double lowest = plot.points.front().x_lowest;
    double highest = plot.points.front().x_highest;
    for (const ScatterPoint& point : plot.points) {
        lowest = std::min(lowest, point.x_lowest);
        highest = std::max(highest, point.x_highest);
    }
    return axis_over(lowest, highest, left, right);
}

Axis y_axis(const ScatterPlot& plot) {
    double lowest = least_drawn(plot.points.front());
    double highest = plot.points.front().y_highest;
    for (const ScatterPoint& point : plot.points) {
        lowest = std::min(lowest, least_drawn(point));
        highest = std::max(highest, point.y_highest);
    }
    return axis_over(lowest, highest, bottom, top);
}

// 1, 2 and 5 times each power of ten; of many powers, only these; of less than one, more.
std::vector<double> ticks_of(const Axis& axis) {
    const double powers = std::log10(axis.highest / axis.lowest);
    const std::vector<double> parts =
        powers > 2.5   ? std::vector{1.0}
        : powers > 0.8 ? std::vector{1.0, 2.0, 5.0}
                       : std::vector{1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};
    std::vector<double> ticks;
    for (double power = std::floor(std::log10(axis.lowest)); power <= std::log10(axis.highest);
         power += 1.0) {
        for (const double part : parts) {
            const double tick = part * std::pow(10.0, power);
            if (tick >= axis.lowest && tick <= axis.highest) {
                ticks.push_back(tick);
            }
        }
    }
    return ticks;
}

std::string line(double x1, double y1, double x2, double y2, const char* kind) {
    return fmt::format("<line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}' class='{}'/>\n", x1,
                       y1, x2, y2, kind);
}

std::string text_at(double x, double y, const char* kind, const std::string& text) {
    return fmt::format("<text x='{:.1f}' y='{:.1f}' class='{}'>", x, y, kind) + escaped(text) +
           "</text>\n";
}

std::string frame(const ScatterPlot& plot, const Axis& x, const Axis& y) {
    std::string svg;
    for (const double tick : ticks_of(x)) {
        svg += line(x.place(tick), top, x.place(tick), bottom, "grid");
        svg += text_at(x.place(tick), bottom + 17.0, "tick middle", fmt::format("{:.4g}", tick));
    }
    for (const double tick : ticks_of(y)) {
        svg += line(left, y.place(tick), right, y.place(tick), "grid");
        svg += text_at(left - 6.0, y.place(tick) + 4.0, "tick end", fmt::format("{:.4g}", tick));
    }
    svg +=
        fmt::format("<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' class='frame'/>\n",
                    left, top, right - left, bottom - top);
    svg += text_at(left, 18.0, "title", plot.title);
    svg += text_at(0.5 * (left + right), height - 10.0, "axis middle", plot.x_label);
    svg += fmt::format("<text transform='translate(16 {:.1f}) rotate(-90)' class='axis middle'>",
                       0.5 * (top + bottom)) +
           escaped(plot.y_label) + "</text>\n";
    return svg;
}

// Where the labels stand: in the order of the points from above, none over another.
std::vector<double> label_places(const ScatterPlot& plot, const Axis& y) {
    std::vector<std::size_t> order(plot.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto wanted = [&](std::size_t i) {
        const ScatterPoint& point = plot.points[i];
        return y.place(point.y > 0.0 ? point.y : point.y_highest);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return wanted(a) < wanted(b); });
    std::vector<double> places(plot.points.size());
    double next = top;
    for (const std::size_t i : order) {
        places[i] = std::max(next, wanted(i));
        next = places[i] + label_height;
    }
    double last = bottom + 10.0; // pushed up again from below
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        places[*i] = std::min(places[*i], last);
        last = places[*i] - label_height;
    }
    return places;
}

std::string draw_point(const ScatterPoint& point, const Axis& x, const Axis& y, double label) {
    const char* const kind = point.dominated ? "dominated" : "best";
    const bool is_bound = point.y <= 0.0;
    const double px = x.place(point.x);
    const double py = y.place(is_bound ? point.y_highest : point.y);
    std::string svg =
        fmt::format("<g class='{}'><title>", kind) + escaped(point.hint) + "</title>\n";
    svg += fmt::format(
        "<polyline points='{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}' class='leader'/>\n", px, py,
        label_left - 26.0, label, label_left - 5.0, label);
    svg += line(x.place(point.x_lowest), py, x.place(point.x_highest), py, "range");
    if (is_bound) { // somewhere below
        svg += line(px, py, px, std::min(py + 14.0, bottom), "range");
        svg += fmt::format("<path d='M{:.1f} {:.1f} l6 -10 h-12 z' class='mark'/>\n", px, py + 5.0);
    } else {
        svg += line(px, y.place(least_drawn(point)), px, y.place(point.y_highest), "range");
        svg += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='5.5' class='mark'/>\n", px, py);
    }
    return svg + text_at(label_left, label + 4.0, "label", point.label) + "</g>\n";
}

} // namespace

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        switch (letter) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        case '\'':
            safe += "&#39;";
            break;
        default:
            safe += letter;
        }
    }
    return safe;
}

std::string to_svg(const ScatterPlot& plot) {
    if (plot.points.empty()) {
        return "";
    }
    const Axis x = x_axis(plot);
    const Axis y = y_axis(plot);
    const std::vector<double> labels = label_places(plot, y);
    std::string svg =
        fmt::format("<svg class='plot' viewBox='0 0 {:.0f} {:.0f}' role='img'>\n", width, height) +
        frame(plot, x, y);
    for (std::size_t i = 0; i < plot.points.size(); ++i) {
        svg += draw_point(plot.points[i], x, y, labels[i]);
    }
    return svg + "</svg>\n";
}

} // namespace raysteps
