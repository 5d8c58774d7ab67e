#pragma once

#include "effort.h"
#include "gpu/shaders.h"
#include "knob.h"
#include "subject.h"

#include <string>

namespace raysteps {

// A triangle test: what fills the slots <triangle> and <real>.
struct TriangleMethod {
    std::string name;
    Parts parts;
};

const std::vector<TriangleMethod>& triangle_methods();

// All triangle tests, on families of rays at the subject (hard_cases/aimed_rays.h).
Knob triangle_knob(const std::string& name, const std::shared_ptr<const Subject>& subject,
                   const Effort& effort);

} // namespace raysteps
