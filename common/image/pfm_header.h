#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

namespace raysteps {

// The three lines that a PFM file begins with.
struct PfmHeader {
    int width = 0;
    int height = 0;
    std::endian byte_order = std::endian::little;
    std::size_t length = 0; // in bytes: where the pixels begin
};

// Throws InputError, beginning with the file's name, where the lines are not those of a color PFM
// file with a size that check_image.h allows and a scale of 1 or -1.
PfmHeader parse_pfm_header(const std::string& name, std::string_view bytes);

} // namespace raysteps
