#include "image/draw_legend.h"

#include "image/color_map.h"
#include "image/compose.h"
#include "image/draw_text.h"

#include <algorithm>
#include <utility>

namespace raysteps {

namespace {

constexpr int margin = 8; // pixels, on every side of the bar
constexpr int bar_height = 16;
constexpr int tick_height = 6;
constexpr int tick_width = 2;
constexpr int line_gap = 4;   // pixels under the ticks, and under the labels
constexpr int label_gap = 16; // pixels between two labels, at least

// The middle label stands at the center, so each side must have room for the wider of the outer
// two.
int least_bar_width(const std::array<std::string, 3>& labels) {
    const int outer = std::max(text_width(labels[0]), text_width(labels[2]));
    return 2 * (outer + label_gap) + text_width(labels[1]);
}

Image draw_bar(int width) {
    Image bar(width, bar_height);
    for (int column = 0; column < width; column++) {
        // The first column shows the lower end and the last one the upper end.
        const glm::vec3 color =
            color_map(static_cast<float>(column) / static_cast<float>(width - 1));
        for (int row = 0; row < bar_height; row++) {
            bar.at(column, row) = color;
        }
    }
    return bar;
}

Image draw_ticks(int width) {
    const Image tick = blank(tick_width, tick_height, ink_color);
    Image ticks = blank(width, tick_height, paper_color);
    ticks = paste(std::move(ticks), tick, 0, 0);
    ticks = paste(std::move(ticks), tick, (width - tick_width) / 2, 0);
    return paste(std::move(ticks), tick, width - tick_width, 0);
}

Image draw_labels(const std::array<std::string, 3>& labels, int width) {
    Image row = blank(width, text_line_height, paper_color);
    row = paste(std::move(row), draw_line(labels[0]), 0, 0);
    row = paste(std::move(row), draw_line(labels[1]), (width - text_width(labels[1])) / 2, 0);
    return paste(std::move(row), draw_line(labels[2]), width - text_width(labels[2]), 0);
}

} // namespace

Image draw_legend(const HeatMapRange& range, const std::string& title, const std::string& note,
                  int width) {
    const std::array<std::string, 3> labels = legend_labels(range);
    const int bar_width = std::max(width - 2 * margin, least_bar_width(labels));
    const bool logarithmic = range.scale == HeatMapScale::logarithmic;
    const std::string whole_title = logarithmic ? title + " (logarithmic)" : title;

    const Image bar = stack(draw_bar(bar_width), draw_ticks(bar_width));
    const Image gap = blank(bar_width, line_gap, paper_color);
    const Image scale = stack(stack(bar, gap), stack(draw_labels(labels, bar_width), gap));
    const Image text =
        stack(draw_paragraph(whole_title, bar_width), draw_paragraph(note, bar_width));
    const Image space = blank(bar_width + 2 * margin, margin, paper_color);
    return stack(stack(space, scale), stack(text, space));
}

} // namespace raysteps
