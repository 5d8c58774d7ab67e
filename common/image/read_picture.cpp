#include "image/read_picture.h"

#include "error/error.h"
#include "file/read_file.h"
#include "image/check_image.h"
#include "image/color_space.h"

#include <stb_image.h>

#include <cstdint>
#include <memory>
#include <string>

namespace raysteps {

namespace {

// A file stores at most 8 bytes a pixel (a PNG of 16 bits), and may carry profiles and texts. More
// than that is refused, because what it unpacks to is bounded by nothing else.
constexpr std::uintmax_t most_bytes_beside_pixels = 1 << 20;
constexpr std::uintmax_t most_bytes_a_pixel = 8;

struct Free {
    void operator()(stbi_uc* components) const { stbi_image_free(components); }
};

[[noreturn]] void fail(const std::filesystem::path& path) {
    throw InputError(path.string() + ": is no picture that can be read, PNG, JPEG or BMP (" +
                     stbi_failure_reason() + "). Save it again as PNG.");
}

} // namespace

Image read_picture(const std::filesystem::path& path) {
    const std::string bytes =
        read_file(path, most_bytes_a_pixel * most_pixels + most_bytes_beside_pixels);
    const auto* start = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(start, size, &width, &height, &channels) == 0) {
        fail(path);
    }
    check_size(path.string(), width, height);
    Image image(width, height);
    if (bytes.size() > most_bytes_a_pixel * image.pixels.size() + most_bytes_beside_pixels) {
        throw InputError(path.string() + ": has " + std::to_string(bytes.size()) +
                         " bytes, too many for its " + std::to_string(image.pixels.size()) +
                         " pixels. Save it again without profiles and texts.");
    }
    const std::unique_ptr<stbi_uc, Free> components(
        stbi_load_from_memory(start, size, &width, &height, &channels, 3));
    if (!components) {
        fail(path);
    }
    const stbi_uc* component = components.get();
    for (glm::vec3& pixel : image.pixels) {
        pixel = {decode_srgb(component[0]), decode_srgb(component[1]), decode_srgb(component[2])};
        component += 3;
    }
    return image;
}

} // namespace raysteps
