#include "image/check_image.h"

#include "error/error.h"

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

} // namespace raysteps
