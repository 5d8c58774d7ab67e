#include "program/window/help_picture.h"

#include "image/image.h"
#include "image/draw_text.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace raysteps {

namespace {

struct HelpLine {
    std::string input;
    std::string effect;
};

const std::array<HelpLine, 9>& help_lines() {
    static const std::array<HelpLine, 9> lines{{
        {"left mouse", "turn the scene"},
        {"shift left, middle", "move it"},
        {"right, wheel", "zoom"},
        {"control left", "tilt"},
        {"R", "back to the first view"},
        {"S", "save the picture"},
        {"C", "print the camera"},
        {"H", "hide these lines"},
        {"Q, Escape", "close"},
    }};
    return lines;
}

constexpr int margin = 16;
constexpr int gap = 24;    // between the columns
constexpr int leading = 4; // between the lines

// Linear: light letters on a dark ground, which is pleasant over any picture.
constexpr glm::vec3 ground_color{0.006f, 0.008f, 0.012f};
constexpr glm::vec3 letter_color{0.9f};

Image light_on_dark(Image text) {
    for (glm::vec3& pixel : text.pixels) {
        pixel = glm::mix(letter_color, ground_color, pixel);
    }
    return text;
}

} // namespace

Image help_picture() {
    int input_width = 0;
    int effect_width = 0;
    for (const HelpLine& line : help_lines()) {
        input_width = std::max(input_width, text_width(line.input));
        effect_width = std::max(effect_width, text_width(line.effect));
    }
    const int line_height = text_line_height + leading;
    const int count = static_cast<int>(help_lines().size());
    Image picture = blank(margin + input_width + gap + effect_width + margin,
                          margin + count * line_height + margin, paper_color);
    int row = margin + leading;
    for (const HelpLine& line : help_lines()) {
        picture = paste(std::move(picture), draw_line(line.input), margin, row);
        picture =
            paste(std::move(picture), draw_line(line.effect), margin + input_width + gap, row);
        row += line_height;
    }
    return light_on_dark(std::move(picture));
}

} // namespace raysteps
