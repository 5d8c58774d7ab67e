#pragma once

#include "image/image.h"

namespace raysteps {

// A picture of one color. Either side may be 0.
Image blank(int width, int height, const glm::vec3& color);

// The canvas with the piece's top left pixel at (column, row); what lies outside is cut off.
Image paste(Image canvas, const Image& piece, int column, int row);

// One over the other on paper, both centered.
Image stack(const Image& top, const Image& bottom);

// One beside the other on paper, both at the top, with that many columns between them.
Image beside(const Image& left, const Image& right, int gap);

} // namespace raysteps
