#include "image/heat_map.h"

#include "basics/error.h"
#include "image/color.h"
#include "image/draw_text.h"
#include "image/image.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace raysteps {

namespace {

constexpr float smallest = std::numeric_limits<float>::denorm_min();
constexpr float largest = std::numeric_limits<float>::max();

HeatMapRange range_around(float value, HeatMapScale scale) {
    if (scale == HeatMapScale::logarithmic) {
        const float upper = value > largest / 2.0f ? largest : 2.0f * value;
        return {std::max(value / 2.0f, smallest), upper, scale};
    }
    if (value == 0.0f) {
        return {0.0f, 1.0f, scale};
    }
    return {std::min(value, 0.0f), std::max(value, 0.0f), scale};
}

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

// 9 digits tell all floats apart; the middle is rounded with its neighbours.
constexpr int least_digits = 4;
constexpr int most_digits = 9;

std::string format_number(double number, int digits) {
    std::array<char, 64> buffer{};
    const std::to_chars_result result = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                                      number, std::chars_format::general, digits);
    return {buffer.data(), result.ptr};
}

} // namespace

HeatMapRange auto_range(std::span<const float> values, HeatMapScale scale) {
    float lower = +std::numeric_limits<float>::infinity();
    float upper = -std::numeric_limits<float>::infinity();
    for (const float value : values) {
        const bool usable = scale == HeatMapScale::linear || value > 0.0f;
        if (std::isfinite(value) && usable) {
            lower = std::min(lower, value);
            upper = std::max(upper, value);
        }
    }
    if (lower > upper) {
        return scale == HeatMapScale::linear ? HeatMapRange{0.0f, 1.0f, scale}
                                             : HeatMapRange{1.0f, 10.0f, scale};
    }
    if (lower == upper) {
        return range_around(lower, scale);
    }
    return {lower, upper, scale};
}

void check_range(const HeatMapRange& range) {
    const bool finite = std::isfinite(range.lower) && std::isfinite(range.upper);
    const bool positive = range.scale == HeatMapScale::linear || range.lower > 0.0f;
    if (!finite || range.lower >= range.upper || !positive) {
        throw InputError("a heat map cannot go from " + std::to_string(range.lower) + " to " +
                         std::to_string(range.upper) +
                         ". Give finite ends, the lower one first, and over 0 where the scale is "
                         "logarithmic.");
    }
}

float fraction_of_range(float value, const HeatMapRange& range) {
    if (std::isnan(value)) {
        return value;
    }
    if (value <= range.lower) {
        return 0.0f;
    }
    if (value >= range.upper) {
        return 1.0f;
    }
    // In double, where neither the difference nor the quotient of two floats overflows.
    const double lower = range.lower;
    const double upper = range.upper;
    if (range.scale == HeatMapScale::logarithmic) {
        return static_cast<float>(std::log(value / lower) / std::log(upper / lower));
    }
    return static_cast<float>((value - lower) / (upper - lower));
}

double middle_of_range(const HeatMapRange& range) {
    const double lower = range.lower;
    const double upper = range.upper;
    return range.scale == HeatMapScale::logarithmic ? std::sqrt(lower * upper)
                                                    : (lower + upper) / 2.0;
}

Image heat_map(std::span<const float> values, int width, int height, const HeatMapRange& range,
               const std::string& title) {
    check_size("heat map \"" + title + "\"", width, height);
    check_range(range);
    Image picture(width, height);
    if (values.size() != picture.pixels.size()) {
        throw InputError("heat map \"" + title + "\": got " + std::to_string(values.size()) +
                         " values for " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels. Give one value for each pixel.");
    }
    std::transform(values.begin(), values.end(), picture.pixels.begin(),
                   [&range](float value) { return color_map(fraction_of_range(value, range)); });
    return stack(picture, draw_legend(range, title, legend_note(values, range), width));
}

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

std::array<std::string, 3> legend_labels(const HeatMapRange& range) {
    std::array<std::string, 3> labels;
    for (int digits = least_digits; digits <= most_digits; digits++) {
        labels = {format_number(range.lower, digits), format_number(middle_of_range(range), digits),
                  format_number(range.upper, digits)};
        if (labels[0] != labels[1] && labels[1] != labels[2]) {
            break;
        }
    }
    return labels;
}

std::string legend_note(std::span<const float> values, const HeatMapRange& range) {
    std::size_t under = 0;
    std::size_t over = 0;
    std::size_t nan = 0;
    for (const float value : values) {
        under += value < range.lower ? 1 : 0;
        over += value > range.upper ? 1 : 0;
        nan += std::isnan(value) ? 1 : 0;
    }
    std::string note;
    const auto add = [&note](std::size_t count, const std::string& what) {
        if (count > 0) {
            note += (note.empty() ? "" : ", ") + std::to_string(count) + what;
        }
    };
    add(under, " under the range");
    add(over, " over the range");
    add(nan, " NaN (magenta)");
    return note;
}

} // namespace raysteps
