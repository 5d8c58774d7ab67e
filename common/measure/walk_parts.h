#pragma once

#include "gpu/shader_catalog.h"

#include <string>

namespace raysteps {

// The parts of a walk's program by their names. Throws InputError where there is no such part.
inline Parts walk_parts(const std::string& triangle, const std::string& structure,
                        const std::string& observer) {
    return {{"triangle", find_part("triangle", triangle)},
            {"structure", find_part("structure", structure)},
            {"observer", "observer/" + observer + ".glsl"}};
}

} // namespace raysteps
