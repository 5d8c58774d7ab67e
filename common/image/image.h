#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// A picture in linear RGB. Row 0 is the top one.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> pixels; // width * height, row by row

    Image() = default;
    Image(int columns, int rows)
        : width(columns), height(rows),
          pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

    glm::vec3& at(int column, int row) { return pixels[index(column, row)]; }
    const glm::vec3& at(int column, int row) const { return pixels[index(column, row)]; }

private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

// The largest picture that is read, written or composed: it bounds what a damaged file can cost.
inline constexpr int most_columns_or_rows = 16384;
inline constexpr std::size_t most_pixels = std::size_t{1} << 26;

// Throws InputError, beginning with the name, where a side is under 1 or the picture is too large.
void check_size(const std::string& name, int width, int height);

// Also throws where the picture does not have width * height pixels.
void check_image(const std::string& name, const Image& image);

// Red, green or blue is NaN: a correct picture has no such pixel.
bool has_nan(const glm::vec3& pixel);

std::size_t count_nan_pixels(const Image& image);

// What stands for NaN in every picture that we write. No color map of ours comes near it.
inline constexpr glm::vec3 nan_color{1.0f, 0.0f, 1.0f};

// A picture of one color. Either side may be 0.
Image blank(int width, int height, const glm::vec3& color);

// The canvas with the piece's top left pixel at (column, row); what lies outside is cut off.
Image paste(Image canvas, const Image& piece, int column, int row);

// One over the other on paper, both centered.
Image stack(const Image& top, const Image& bottom);

// One beside the other on paper, both at the top, with that many columns between them.
Image beside(const Image& left, const Image& right, int gap);

// The pictures from left to right, a thin white gap between them, each with its caption below it.
// A caption wraps at the width of its picture. Throws InputError where there is no picture, where
// their heights differ, or where there is not one caption for each.
Image side_by_side(std::span<const Image> images, std::span<const std::string> captions);

} // namespace raysteps
