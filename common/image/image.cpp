#include "image/image.h"

#include "basics/error.h"
#include "image/draw_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace raysteps {

void check_size(const std::string& name, int width, int height) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width < 1 || height < 1) {
        throw InputError(name + ": a picture of " + size +
                         " pixels has no pixel. Give it at least one column and one row.");
    }
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (width > most_columns_or_rows || height > most_columns_or_rows || pixels > most_pixels) {
        throw InputError(name + ": a picture of " + size +
                         " pixels is too large. Keep each side to " +
                         std::to_string(most_columns_or_rows) + " pixels and all of it to " +
                         std::to_string(most_pixels) + ".");
    }
}

void check_image(const std::string& name, const Image& image) {
    check_size(name, image.width, image.height);
    const std::size_t pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.pixels.size() != pixels) {
        throw InputError(name + ": the picture holds " + std::to_string(image.pixels.size()) +
                         " pixels, but " + std::to_string(image.width) + " x " +
                         std::to_string(image.height) + " are " + std::to_string(pixels) +
                         ". Make it with Image(columns, rows).");
    }
}

bool has_nan(const glm::vec3& pixel) {
    return std::isnan(pixel.x) || std::isnan(pixel.y) || std::isnan(pixel.z);
}

std::size_t count_nan_pixels(const Image& image) {
    return static_cast<std::size_t>(
        std::count_if(image.pixels.begin(), image.pixels.end(), has_nan));
}

Image blank(int width, int height, const glm::vec3& color) {
    Image image(width, height);
    std::fill(image.pixels.begin(), image.pixels.end(), color);
    return image;
}

Image paste(Image canvas, const Image& piece, int column, int row) {
    const int first_x = std::max(0, -column);
    const int first_y = std::max(0, -row);
    const int last_x = std::min(piece.width, canvas.width - column);
    const int last_y = std::min(piece.height, canvas.height - row);
    for (int y = first_y; y < last_y; y++) {
        for (int x = first_x; x < last_x; x++) {
            canvas.at(column + x, row + y) = piece.at(x, y);
        }
    }
    return canvas;
}

Image stack(const Image& top, const Image& bottom) {
    const int width = std::max(top.width, bottom.width);
    Image image = blank(width, top.height + bottom.height, paper_color);
    image = paste(std::move(image), top, (width - top.width) / 2, 0);
    return paste(std::move(image), bottom, (width - bottom.width) / 2, top.height);
}

Image beside(const Image& left, const Image& right, int gap) {
    const int height = std::max(left.height, right.height);
    Image image = blank(left.width + gap + right.width, height, paper_color);
    image = paste(std::move(image), left, 0, 0);
    return paste(std::move(image), right, left.width + gap, 0);
}

namespace {

constexpr int gap = 4;           // pixels
constexpr int caption_gap = 8;   // pixels on every side of a caption
constexpr int least_width = 112; // of a panel: its caption has room for words under a thumbnail

int panel_width(const Image& image) {
    return std::max(image.width, least_width);
}

void check_panels(std::span<const Image> images, std::span<const std::string> captions) {
    if (images.empty() || images.size() != captions.size()) {
        throw InputError("cannot join " + std::to_string(images.size()) + " pictures with " +
                         std::to_string(captions.size()) +
                         " captions. Give at least one picture, and one caption for each.");
    }
    std::size_t width = 0;
    for (std::size_t i = 0; i < images.size(); i++) {
        check_image("picture " + std::to_string(i + 1), images[i]);
        if (images[i].height != images[0].height) {
            throw InputError("cannot join pictures of " + std::to_string(images[0].height) +
                             " and " + std::to_string(images[i].height) +
                             " rows. Render them at the same height.");
        }
        width += static_cast<std::size_t>(panel_width(images[i]) + gap);
    }
    if (width > most_columns_or_rows) {
        throw InputError("the joined pictures would have " + std::to_string(width) +
                         " columns, over the limit of " + std::to_string(most_columns_or_rows) +
                         ". Join fewer of them.");
    }
}

Image draw_panel(const Image& image, const std::string& caption) {
    const int width = panel_width(image);
    const Image space = blank(width, caption_gap, paper_color);
    const Image text = draw_paragraph(caption, width - 2 * caption_gap);
    return stack(stack(image, space), stack(text, space));
}

} // namespace

Image side_by_side(std::span<const Image> images, std::span<const std::string> captions) {
    check_panels(images, captions);
    Image joined = draw_panel(images[0], captions[0]);
    for (std::size_t i = 1; i < images.size(); i++) {
        joined = beside(joined, draw_panel(images[i], captions[i]), gap);
    }
    return joined;
}

} // namespace raysteps
