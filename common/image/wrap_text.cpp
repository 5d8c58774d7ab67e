#include "image/draw_text.h"

#include <sstream>

namespace raysteps {

namespace {

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
