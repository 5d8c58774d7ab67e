#include "image/heat_map.h"

#include "count_ink.h"
#include "support/error_of.h"

#include "image/color.h"

#include "catch.h"

#include <limits>
#include <vector>

using namespace raysteps;

namespace {

constexpr int width = 400;
constexpr int height = 10;
const HeatMapRange range{0.0f, 8.0f};

std::vector<float> some_values() {
    std::vector<float> values(static_cast<std::size_t>(width * height), 4.0f);
    values[1] = 8.0f;
    values[2] = std::numeric_limits<float>::quiet_NaN();
    return values;
}

// The first row under the picture whose left end has the bar's first color.
int first_bar_row(const Image& image, int margin) {
    int row = height;
    while (row < image.height && image.at(margin, row) != color_map(0.0f)) {
        row++;
    }
    return row;
}

} // namespace

TEST_CASE("a heat map shows each value's color over its legend", "[image]") {
    const Image image = heat_map(some_values(), width, height, range, "steps");
    REQUIRE(image.width == width);
    REQUIRE(image.height > height);
    CHECK(image.at(0, 0) == color_map(0.5f));
    CHECK(image.at(1, 0) == color_map(1.0f));
    CHECK(image.at(2, 0) == glm::vec3(1.0f, 0.0f, 1.0f));
    CHECK(image.at(width - 1, height - 1) == color_map(0.5f));
}

TEST_CASE("a legend has a bar of all colors with three numbers and a title under it", "[image]") {
    constexpr int margin = 8;
    const Image image = heat_map(some_values(), width, height, range, "steps");
    const int bar = first_bar_row(image, margin);
    REQUIRE(bar < image.height);
    for (int column = margin; column < width - margin; column++) {
        const float value =
            static_cast<float>(column - margin) / static_cast<float>(width - 2 * margin - 1);
        CHECK(image.at(column, bar) == color_map(value));
    }
    const int labels = bar + 16 + 6 + 4; // under the bar, its ticks and a gap
    const int title = labels + text_line_height;
    CHECK(count_ink(image, {0, width / 3, labels, title}) > 0);
    CHECK(count_ink(image, {width / 3, 2 * width / 3, labels, title}) > 0);
    CHECK(count_ink(image, {2 * width / 3, width, labels, title}) > 0);
    CHECK(count_ink(image, {0, width, title, image.height}) > 0);
    const int border = count_paper(image, {0, margin, height, image.height}) +
                       count_paper(image, {width - margin, width, height, image.height});
    CHECK(border == 2 * margin * (image.height - height));
}

TEST_CASE("a heat map narrower than its legend stands centered over it", "[image]") {
    const std::vector<float> values(4, 8.0f);
    const Image image = heat_map(values, 2, 2, range, "steps");
    REQUIRE(image.width > 2);
    const int left = (image.width - 2) / 2;
    CHECK(image.at(left, 0) == color_map(1.0f));
    CHECK(image.at(left + 1, 1) == color_map(1.0f));
    CHECK(image.at(left - 1, 0) == paper_color);
    CHECK(image.at(left + 2, 0) == paper_color);
}

TEST_CASE("a longer title makes the legend higher and never wider", "[image]") {
    const Image one_line = heat_map(some_values(), width, height, range, "steps");
    const Image lines = heat_map(some_values(), width, height, range, std::string(200, 'x'));
    CHECK(lines.width == width);
    CHECK(lines.height > one_line.height);
}

TEST_CASE("a legend's numbers are short and can be told apart", "[image]") {
    using Labels = std::array<std::string, 3>;
    CHECK(legend_labels({0.0f, 1.0f}) == Labels{"0", "0.5", "1"});
    CHECK(legend_labels({0.0f, 255.0f}) == Labels{"0", "127.5", "255"});
    CHECK(legend_labels({1.0f, 10000.0f, HeatMapScale::logarithmic}) ==
          Labels{"1", "100", "1e+04"});
    CHECK(legend_labels({16777210.0f, 16777214.0f}) == Labels{"16777210", "16777212", "16777214"});
}

TEST_CASE("a legend says what the colors cannot", "[image]") {
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> values{-infinity, 0.0f,     8.0f,
                                    9.0f,      infinity, std::numeric_limits<float>::quiet_NaN()};
    CHECK(legend_note(values, range) == "1 under the range, 2 over the range, 1 NaN (magenta)");
    CHECK(legend_note(std::vector<float>{0.0f, 8.0f}, range).empty());
}

TEST_CASE("a heat map of wrong size or range is an error", "[image]") {
    const std::vector<float> values(4, 1.0f);
    const auto error = [&](int columns, int rows, const HeatMapRange& ends) {
        return error_of([&] { heat_map(values, columns, rows, ends, "steps"); });
    };
    CHECK(error(2, 2, range).empty());
    CHECK(error(3, 2, range).find("got 4 values for 3 x 2 pixels") != std::string::npos);
    CHECK(error(-2, -2, range).find("no pixel") != std::string::npos);
    CHECK(error(1 << 30, 1 << 30, range).find("too large") != std::string::npos);
    CHECK(error(2, 2, {1.0f, 0.0f}).find("cannot go from") != std::string::npos);
}
