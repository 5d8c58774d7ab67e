#include "image/draw_legend.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <vector>

namespace raysteps {

namespace {

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
    add(nan, " not a number (magenta)");
    return note;
}

} // namespace raysteps
