#include "image/image_file.h"

#include "basics/error.h"
#include "basics/file.h"
#include "basics/text.h"
#include "image/color.h"
#include "image/image.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

namespace {

// No line of a valid header is longer.
constexpr std::size_t most_line_length = 64;

std::string_view read_line(const std::string& name, std::string_view bytes, int number) {
    const std::size_t end = bytes.substr(0, most_line_length).find('\n');
    if (end == std::string_view::npos) {
        throw InputError(name + ":" + std::to_string(number) +
                         ": the header of a PFM file has three short lines, but this one does not "
                         "end. Save it again as color PFM.");
    }
    return bytes.substr(0, end);
}

struct Size {
    int width = 0;
    int height = 0;
};

std::optional<Size> parse_pfm_size(std::string_view line) {
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<int> width = parse_number<int>(line.substr(0, space));
    const std::optional<int> height = parse_number<int>(line.substr(space + 1));
    if (!width || !height) {
        return std::nullopt;
    }
    return Size{*width, *height};
}

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

std::string little_endian_bytes(float number) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(number);
    return {static_cast<char>(bits), static_cast<char>(bits >> 8), static_cast<char>(bits >> 16),
            static_cast<char>(bits >> 24)};
}

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

// A file stores at most 8 bytes per pixel (a PNG of 16 bits), and may carry profiles and texts.
// More than that is refused, because what it unpacks to is bounded by nothing else.
constexpr std::uintmax_t most_bytes_beside_pixels = 1 << 20;
constexpr std::uintmax_t most_bytes_a_pixel = 8;

struct Free {
    void operator()(stbi_uc* components) const { stbi_image_free(components); }
};

[[noreturn]] void fail(const std::string& name) {
    throw InputError(name + ": is not a PNG, JPEG, TGA or BMP picture that can be read (" +
                     stbi_failure_reason() + "). Save it again as PNG.");
}

} // namespace

PfmHeader parse_pfm_header(const std::string& name, std::string_view bytes) {
    const std::string_view kind = read_line(name, bytes, 1);
    if (kind != "PF") {
        throw InputError(name + ":1: a color PFM file begins with the line PF, but this one does "
                                "not. Save it again as color PFM.");
    }
    PfmHeader header;
    header.length = kind.size() + 1;

    const std::string_view size_line = read_line(name, bytes.substr(header.length), 2);
    const std::optional<Size> size = parse_pfm_size(size_line);
    if (!size) {
        throw InputError(name + ":2: this line must be the width and the height, two whole numbers "
                                "and a space between them. Save it again as color PFM.");
    }
    check_size(name + ":2", size->width, size->height);
    header.width = size->width;
    header.height = size->height;
    header.length += size_line.size() + 1;

    const std::string_view scale_line = read_line(name, bytes.substr(header.length), 3);
    const double scale = parse_number<double>(scale_line).value_or(0.0);
    if (scale != 1.0 && scale != -1.0) {
        throw InputError(name + ":3: this line must be the scale, 1.0 for big endian or -1.0 for "
                                "little endian. Save it again with one of them.");
    }
    header.byte_order = scale < 0.0 ? std::endian::little : std::endian::big;
    header.length += scale_line.size() + 1;
    return header;
}

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

namespace {

// Row by row, with that many components a pixel.
struct DecodedPicture {
    int width = 0;
    int height = 0;
    int channels = 0; // of the file
    std::unique_ptr<stbi_uc, Free> components;
};

DecodedPicture decode(const std::string& bytes, const std::string& name, int components) {
    const auto* start = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    DecodedPicture decoded;
    if (stbi_info_from_memory(start, size, &decoded.width, &decoded.height, &decoded.channels) ==
        0) {
        fail(name);
    }
    check_size(name, decoded.width, decoded.height);
    const std::size_t pixels =
        static_cast<std::size_t>(decoded.width) * static_cast<std::size_t>(decoded.height);
    if (bytes.size() > most_bytes_a_pixel * pixels + most_bytes_beside_pixels) {
        throw InputError(name + ": has " + std::to_string(bytes.size()) +
                         " bytes, too many for its " + std::to_string(pixels) +
                         " pixels. Save it again without profiles and texts.");
    }
    decoded.components.reset(stbi_load_from_memory(start, size, &decoded.width, &decoded.height,
                                                   &decoded.channels, components));
    if (!decoded.components) {
        fail(name);
    }
    return decoded;
}

} // namespace

std::string read_picture_bytes(const std::filesystem::path& path) {
    return read_file(path, most_bytes_a_pixel * most_pixels + most_bytes_beside_pixels);
}

Image read_picture(const std::filesystem::path& path) {
    return decode_picture(read_picture_bytes(path), path.string());
}

Image decode_picture(const std::string& bytes, const std::string& name) {
    const DecodedPicture decoded = decode(bytes, name, 3);
    Image image(decoded.width, decoded.height);
    const stbi_uc* component = decoded.components.get();
    for (glm::vec3& pixel : image.pixels) {
        pixel = {decode_srgb(component[0]), decode_srgb(component[1]), decode_srgb(component[2])};
        component += 3;
    }
    return image;
}

Opacity decode_opacity(const std::string& bytes, const std::string& name) {
    const DecodedPicture decoded = decode(bytes, name, 2); // grey and alpha
    Opacity opacity{decoded.width, decoded.height, decoded.channels % 2 == 0, {}};
    const std::size_t pixels =
        static_cast<std::size_t>(opacity.width) * static_cast<std::size_t>(opacity.height);
    opacity.values.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        opacity.values.push_back(decoded.components.get()[2 * i + (opacity.is_alpha ? 1 : 0)]);
    }
    return opacity;
}

} // namespace raysteps
