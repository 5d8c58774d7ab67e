#pragma once

#include "geometry/layout.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// Rays from the text of a .csv file; the path is named where it is wrong. Throws InputError.
std::vector<Ray> parse_ray_csv(std::string_view text, const std::filesystem::path& path);

} // namespace raysteps
