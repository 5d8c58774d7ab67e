#include "image/write_png.h"

#include "error/error.h"
#include "file/write_file.h"
#include "image/check_image.h"
#include "image/color_space.h"
#include "image/count_nan_pixels.h"

#include <stb_image_write.h>

#include <cstdint>
#include <string>
#include <vector>

namespace raysteps {

namespace {

std::vector<std::uint8_t> encode(const Image& image) {
    std::vector<std::uint8_t> components;
    components.reserve(3 * image.pixels.size());
    for (const glm::vec3& pixel : image.pixels) {
        const glm::vec3 shown = has_nan(pixel) ? nan_color : pixel;
        components.push_back(encode_srgb(shown.x));
        components.push_back(encode_srgb(shown.y));
        components.push_back(encode_srgb(shown.z));
    }
    return components;
}

void append(void* bytes, void* piece, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(piece),
                                             static_cast<std::size_t>(size));
}

} // namespace

void write_png(const std::filesystem::path& path, const Image& image) {
    check_image(path.string(), image);
    const std::vector<std::uint8_t> components = encode(image);
    std::string bytes;
    const int done = stbi_write_png_to_func(append, &bytes, image.width, image.height, 3,
                                            components.data(), 3 * image.width);
    if (done == 0) {
        throw MachineError(path.string() +
                           ": cannot be encoded: not enough memory. Make a smaller picture.");
    }
    write_file(path, bytes);
}

} // namespace raysteps
