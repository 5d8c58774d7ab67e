#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

enum class PlyFormat { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);

// A number for each element, or a list of numbers, which begins with its length.
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType length_type = PlyType::uint8;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::string picture;    // of a comment TextureFile, which MeshLab writes
    int skipped_line = 0;   // the first that PLY does not know; 0 where there is none
    std::size_t length = 0; // in bytes: where the elements begin
};

// Throws InputError with file and line where the bytes do not begin with a PLY header.
PlyHeader parse_ply_header(std::string_view bytes, const std::filesystem::path& path);

} // namespace raysteps
