#pragma once

#include "scene/material.h"

#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// The values of one MTL statement that is a number or a colour, brought into their range.
struct MtlValues {
    std::string statement;  // with a line end; empty where the values cannot be brought right
    std::string correction; // a sentence without its full stop; empty where nothing was wrong
};

// Is the keyword that of a number or a colour: Kd, Ks, Ke, Kt, Tf, Ns, Ni, d, Tr or illum?
bool has_mtl_values(std::string_view keyword);

// The words of such a statement, keyword first. Tr comes back as d, and Kt as Tf. One value for a
// colour is a grey.
MtlValues checked_mtl_values(const std::vector<std::string_view>& words);

// All statements that make the material, so that no default is left to the reader.
std::string to_mtl(const Material& material);

} // namespace raysteps
