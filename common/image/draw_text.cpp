#include "image/draw_text.h"

#include "image/image.h"

#include <stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <utility>

namespace raysteps {

namespace {

// The font's own pixels are too small to read on today's screens.
constexpr int text_scale = 2;
static_assert(text_line_height == 12 * text_scale); // stb_easy_font advances 12 a line

// What stb_easy_font_print writes: a rectangle's corners, clockwise from the top left one.
struct Corner {
    float x;
    float y;
    float z;
    std::array<unsigned char, 4> color;
};
using Rectangle = std::array<Corner, 4>;
static_assert(sizeof(Rectangle) == 64);

constexpr std::size_t most_rectangles_a_character = 32;

// stb_easy_font reads past its table for anything but printable ASCII.
std::string printable(const std::string& line) {
    std::string result;
    for (const char character : line) {
        const auto byte = static_cast<unsigned char>(character);
        const bool goes_on_with_a_character = (byte & 0xC0) == 0x80; // UTF-8
        if (goes_on_with_a_character) {
            continue;
        }
        const bool drawable = byte >= ' ' && byte <= '~';
        result += drawable ? character : '?';
    }
    return result;
}

bool starts_a_character(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; // UTF-8
}

// The word in pieces that fit, the last one shorter than the others.
std::vector<std::string> cut_word(const std::string& word, int width) {
    std::vector<std::string> pieces(1);
    for (const char byte : word) {
        std::string& piece = pieces.back();
        const bool full = !piece.empty() && text_width(piece + byte) > width;
        if (full && starts_a_character(byte)) {
            pieces.emplace_back(1, byte);
        } else {
            piece += byte;
        }
    }
    return pieces;
}

std::vector<std::string> wrap_line(const std::string& line, int width) {
    std::vector<std::string> lines;
    std::istringstream words(line);
    std::string word;
    while (words >> word) {
        if (!lines.empty() && text_width(lines.back() + " " + word) <= width) {
            lines.back() += " " + word;
            continue;
        }
        for (const std::string& piece : cut_word(word, width)) {
            lines.push_back(piece);
        }
    }
    return lines;
}

} // namespace

int text_width(const std::string& line) {
    return text_scale * stb_easy_font_width(printable(line).data());
}

Image draw_line(const std::string& line) {
    std::string text = printable(line);
    std::vector<Rectangle> rectangles(most_rectangles_a_character * (text.size() + 1));
    const auto buffer_size = static_cast<int>(rectangles.size() * sizeof(Rectangle));
    const int count =
        stb_easy_font_print(0.0f, 0.0f, text.data(), nullptr, rectangles.data(), buffer_size);

    Image image = blank(text_width(line), text_line_height, paper_color);
    for (int i = 0; i < count; i++) {
        const Rectangle& rectangle = rectangles[i];
        const int left = text_scale * static_cast<int>(rectangle[0].x);
        const int top = text_scale * static_cast<int>(rectangle[0].y);
        const int right = text_scale * static_cast<int>(rectangle[2].x);
        const int bottom = text_scale * static_cast<int>(rectangle[2].y);
        image = paste(std::move(image), blank(right - left, bottom - top, ink_color), left, top);
    }
    return image;
}

Image draw_paragraph(const std::string& text, int width) {
    Image image = blank(width, 0, paper_color);
    for (const std::string& line : wrap_text(text, width)) {
        const Image drawn = draw_line(line);
        const Image row = paste(blank(width, text_line_height, paper_color), drawn,
                                std::max(0, (width - drawn.width) / 2), 0);
        image = stack(image, row);
    }
    return image;
}

std::vector<std::string> wrap_text(const std::string& text, int width) {
    std::vector<std::string> lines;
    std::istringstream rest(text);
    std::string line;
    while (std::getline(rest, line)) {
        for (const std::string& piece : wrap_line(line, width)) {
            lines.push_back(piece);
        }
    }
    return lines;
}

} // namespace raysteps
