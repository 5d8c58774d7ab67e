#pragma once

#include "image/image.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// The three lines that a PFM file begins with.
struct PfmHeader {
    int width = 0;
    int height = 0;
    std::endian byte_order = std::endian::little;
    std::size_t length = 0; // in bytes: where the pixels begin
};

// Throws InputError, beginning with the file's name, where the lines are not those of a color PFM
// file with a size that check_image allows and a scale of 1 or -1.
PfmHeader parse_pfm_header(const std::string& name, std::string_view bytes);

// Writes the picture as 8-bit sRGB. Components are clamped to [0, 1] and rounded to the nearest
// step; a pixel that has NaN is magenta (count_nan_pixels counts them), so it cannot pass for
// black. Makes the folders that lack; a write that fails leaves the old file as it was. Throws
// InputError with the path and the reason.
void write_png(const std::filesystem::path& path, const Image& image);

// Writes the linear floats as they are, so that read_pfm returns the same bits, NaN included:
// "PF", the size, "-1.0" for little endian, then rows of RGB from the bottom row to the top one
// (Debevec, "Portable FloatMap Image Format"). Makes the folders that lack; a write that fails
// leaves the old file as it was. Throws InputError with the path and the reason.
void write_pfm(const std::filesystem::path& path, const Image& image);

// Reads a color PFM file of either byte order whose scale is 1 or -1. Throws InputError where the
// header or the file's length is not exactly what the format asks for.
Image read_pfm(const std::filesystem::path& path);

// The colors of a PNG, JPEG, TGA or BMP file as linear RGB; opacity is left out, and 16-bit files
// become 8-bit ones. Its content decides what it is, not its name. Throws InputError where the file
// is none of these, is damaged, or is larger than check_image allows.
Image read_picture(const std::filesystem::path& path);

// The same of such a file's bytes; the name is for sentences.
Image decode_picture(const std::string& bytes, const std::string& name);

// How opaque a picture is, from 0 to 255, row by row from the top: by its alpha channel, else by
// its grey.
struct Opacity {
    int width = 0;
    int height = 0;
    bool is_alpha = false;
    std::vector<std::uint8_t> values;
};

// Throws as read_picture does.
Opacity decode_opacity(const std::string& bytes, const std::string& name);

// At most so many bytes has a picture file that can be read.
std::string read_picture_bytes(const std::filesystem::path& path);

} // namespace raysteps
