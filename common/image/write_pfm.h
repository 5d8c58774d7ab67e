#pragma once

#include "image/image.h"

#include <filesystem>

namespace raysteps {

// Writes the linear floats as they are, so that read_pfm returns the same bits, NaN included:
// "PF", the size, "-1.0" for little endian, then rows of RGB from the bottom row to the top one
// (Debevec, "Portable FloatMap Image Format"). Makes the folders that lack; a write that fails
// leaves the old file as it was. Throws InputError with the path and the reason.
void write_pfm(const std::filesystem::path& path, const Image& image);

// Reads a color PFM file of either byte order whose scale is 1 or -1. Throws InputError where the
// header or the file's length is not exactly what the format asks for.
Image read_pfm(const std::filesystem::path& path);

} // namespace raysteps
