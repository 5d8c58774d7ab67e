#pragma once

#include "image/image.h"

#include <string>
#include <vector>

namespace raysteps {

inline constexpr glm::vec3 paper_color{1.0f};
inline constexpr glm::vec3 ink_color{0.0f};

// All text has one size, in pixels.
inline constexpr int text_line_height = 24;

// The width of one line, in pixels. Characters beyond ASCII are drawn as question marks.
int text_width(const std::string& line);

// One line, ink on paper: text_width wide and text_line_height high.
Image draw_line(const std::string& line);

// Cuts the text into lines of at most that many pixels, at spaces and line breaks; a word that is
// wider is cut where it must be. A line has at least one character, however narrow the width.
std::vector<std::string> wrap_text(const std::string& text, int width);

// The text on paper of that width, each line centered.
Image draw_paragraph(const std::string& text, int width);

} // namespace raysteps
