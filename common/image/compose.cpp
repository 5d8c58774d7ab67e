#include "image/compose.h"

#include "image/draw_text.h"

#include <algorithm>
#include <utility>

namespace raysteps {

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

} // namespace raysteps
