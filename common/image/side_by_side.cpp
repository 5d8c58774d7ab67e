#include "image/side_by_side.h"

#include "error/error.h"
#include "image/check_image.h"
#include "image/compose.h"
#include "image/draw_text.h"

#include <algorithm>
#include <cstddef>

namespace raysteps {

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
