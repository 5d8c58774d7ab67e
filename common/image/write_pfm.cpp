#include "image/write_pfm.h"

#include "file/write_file.h"
#include "image/check_image.h"

#include <bit>
#include <cstdint>
#include <string>

namespace raysteps {

namespace {

std::string little_endian_bytes(float number) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(number);
    return {static_cast<char>(bits), static_cast<char>(bits >> 8), static_cast<char>(bits >> 16),
            static_cast<char>(bits >> 24)};
}

} // namespace

void write_pfm(const std::filesystem::path& path, const Image& image) {
    check_image(path.string(), image);
    std::string bytes =
        "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
    bytes.reserve(bytes.size() + 12 * image.pixels.size());
    for (int row = image.height - 1; row >= 0; row--) {
        for (int column = 0; column < image.width; column++) {
            const glm::vec3& pixel = image.at(column, row);
            bytes += little_endian_bytes(pixel.x);
            bytes += little_endian_bytes(pixel.y);
            bytes += little_endian_bytes(pixel.z);
        }
    }
    write_file(path, bytes);
}

} // namespace raysteps
