#pragma once

#include "fuzz.h"

#include <filesystem>
#include <vector>

namespace raysteps {

// Writes the fault's mesh as an OBJ file and its rays as a .csv file of that folder, with all
// digits, so that the chapters' programs can trace them: --scene and --rays. Returns the paths.
std::vector<std::filesystem::path> write_fault(const FuzzFault& fault,
                                               const std::filesystem::path& folder);

} // namespace raysteps
