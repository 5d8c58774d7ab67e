#pragma once

#include "basics/ray.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// Rays and hits of anybody's own, as docs/ray_files.md describes them.

// A .csv file with the columns origin_x, origin_y, origin_z, direction_x, direction_y, direction_z,
// t_min and t_max in any order, or any other file as 8 little-endian float32 per ray in that order.
// Every number is finite but t_max, which may be infinite; a direction is not zero. Throws
// InputError that names the file and the ray or line.
std::vector<Ray> read_ray_file(const std::filesystem::path& path);

// The same files, to be read again: a .csv file gives back the same bits. Throws InputError.
void write_ray_file(const std::filesystem::path& path, std::span<const Ray> rays);

// A .csv file with the columns t, u, v, triangle, or any other file as 16 bytes per hit: t, u, v as
// little-endian float32 and the triangle as int32, -1 for none. Throws InputError.
void write_hit_file(const std::filesystem::path& path, std::span<const Hit> hits);

// Rays from the text of a .csv file; the path is named where it is wrong. Throws InputError.
std::vector<Ray> parse_ray_csv(std::string_view text, const std::filesystem::path& path);

} // namespace raysteps
