#pragma once

#include "basics/ray.h"
#include "scene/scene.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// Rays and hits of anybody's own, as docs/ray_files.md describes them.

// A .csv file with the columns origin_x, origin_y, origin_z, direction_x, direction_y, direction_z,
// t_min and t_max in any order, or any other file as 8 little-endian float32 per ray in that order.
// Every number is finite but t_max, which may be infinite; a direction is not zero. Origins are in
// the coordinates of a scene's files, and come back as seen from the scene's origin. Throws
// InputError that names the file and the ray or line.
std::vector<Ray> read_ray_file(const std::filesystem::path& path,
                               const glm::dvec3& origin = glm::dvec3(0.0));

// A sentence on those rays whose hits are not promised to be the same in every structure and on
// every machine (docs/numerics.md), as t, or a product with their direction, is too small or too
// large for a float; empty where there are none. The reach is that of the structures
// (structure/padding.h), M:
// - A GPU may put 0 for a number under 2^-126. For a t, that moves a point by up to 2^-126 |d|
// along
//   the longest axis of the direction d: for the t of a hit and for that of a plane. The padding
//   has room for 7 e M = 7 * 2^-24 M, so for both as long as |d| <= 2^103 M.
// - A hit as far as M has a t of M / |d|, which overflows from 2^128 on.
// - A component under 2^-126 may be taken for 0, which is another direction.
std::string unusual_lengths(std::span<const Ray> rays, const std::filesystem::path& path,
                            double reach);

// The same files, to be read again: a .csv file gives back the same bits. Throws InputError.
void write_ray_file(const std::filesystem::path& path, std::span<const Ray> rays);

// A .csv file with the columns t, u, v, triangle, or any other file as 16 bytes per hit: t, u, v as
// little-endian float32 and the triangle as int32, -1 for none. Throws InputError.
void write_hit_file(const std::filesystem::path& path, std::span<const Hit> hits);

// The same for hits in a scene: of one from files, a .csv file has a fifth column `name`, with what
// the files call the triangle; empty for none.
void write_hit_file(const std::filesystem::path& path, std::span<const Hit> hits,
                    const Scene& scene);

// Hits that anybody wrote in these forms. Throws InputError that names the file and the hit or
// line.
std::vector<Hit> read_hit_file(const std::filesystem::path& path);

// Rays from the text of a .csv file; the path is named where it is wrong. Throws InputError.
std::vector<Ray> parse_ray_csv(std::string_view text, const std::filesystem::path& path,
                               const glm::dvec3& origin = glm::dvec3(0.0));

} // namespace raysteps
