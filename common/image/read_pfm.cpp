#include "image/write_pfm.h"

#include "error/error.h"
#include "file/read_file.h"
#include "image/check_image.h"
#include "image/pfm_header.h"

#include <bit>
#include <cstdint>
#include <string>

namespace raysteps {

namespace {

constexpr std::size_t bytes_a_pixel = 12;
constexpr std::size_t most_header_bytes = 192;

std::uint32_t byte_at(std::string_view bytes, std::size_t index) {
    return static_cast<unsigned char>(bytes[index]);
}

float read_float(std::string_view bytes, std::endian byte_order) {
    const std::uint32_t little = byte_at(bytes, 0) | byte_at(bytes, 1) << 8 |
                                 byte_at(bytes, 2) << 16 | byte_at(bytes, 3) << 24;
    const std::uint32_t big = byte_at(bytes, 3) | byte_at(bytes, 2) << 8 | byte_at(bytes, 1) << 16 |
                              byte_at(bytes, 0) << 24;
    return std::bit_cast<float>(byte_order == std::endian::little ? little : big);
}

} // namespace

Image read_pfm(const std::filesystem::path& path) {
    const std::string bytes = read_file(path, bytes_a_pixel * most_pixels + most_header_bytes);
    const PfmHeader header = parse_pfm_header(path.string(), bytes);
    const std::size_t expected = header.length + bytes_a_pixel *
                                                     static_cast<std::size_t>(header.width) *
                                                     static_cast<std::size_t>(header.height);
    if (bytes.size() != expected) {
        throw InputError(path.string() + ": a PFM file of " + std::to_string(header.width) + " x " +
                         std::to_string(header.height) + " pixels has " + std::to_string(expected) +
                         " bytes, but this one has " + std::to_string(bytes.size()) +
                         ". Copy or save it again.");
    }
    Image image(header.width, header.height);
    std::string_view rest = std::string_view(bytes).substr(header.length);
    for (int row = image.height - 1; row >= 0; row--) {
        for (int column = 0; column < image.width; column++) {
            image.at(column, row) = {read_float(rest, header.byte_order),
                                     read_float(rest.substr(4), header.byte_order),
                                     read_float(rest.substr(8), header.byte_order)};
            rest.remove_prefix(bytes_a_pixel);
        }
    }
    return image;
}

} // namespace raysteps
