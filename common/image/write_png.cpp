#include "image/write_png.h"

#include "error/error.h"
#include "file/write_file.h"
#include "image/check_image.h"
#include "image/color_space.h"
#include "image/count_nan_pixels.h"

#include <stb_image_write.h>

#include <cstdint>
#include <new>
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

struct Output {
    std::string bytes;
    bool fits = true;
};

// No exception may pass through stb's C code.
void append(void* output, void* piece, int size) {
    auto& [bytes, fits] = *static_cast<Output*>(output);
    try {
        bytes.append(static_cast<const char*>(piece), static_cast<std::size_t>(size));
    } catch (const std::bad_alloc&) {
        fits = false;
    }
}

} // namespace

void write_png(const std::filesystem::path& path, const Image& image) {
    check_image(path.string(), image);
    const std::vector<std::uint8_t> components = encode(image);
    Output output;
    const int done = stbi_write_png_to_func(append, &output, image.width, image.height, 3,
                                            components.data(), 3 * image.width);
    if (done == 0 || !output.fits) {
        throw MachineError(path.string() +
                           ": cannot be encoded: not enough memory. Make a smaller picture.");
    }
    write_file(path, output.bytes);
}

} // namespace raysteps
