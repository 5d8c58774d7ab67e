#pragma once

#include "scene/obj_findings.h"

#include <string>
#include <string_view>

namespace raysteps {

struct CleanMtl {
    std::string text;
    Findings findings;
};

// An MTL text in which every value is usable and every default is written out, since tinyobjloader
// lets through Ni 0, d 2 and nan, makes `Kd 0.5` (a grey) red, and has other defaults than
// Material. Reflectances and opacity are brought to between 0 and 1, exponents (Ns) to at most 1e6;
// a line that cannot be brought right is left out. The text is empty where it holds no material.
CleanMtl clean_mtl(std::string_view text);

} // namespace raysteps
