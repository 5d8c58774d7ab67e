#pragma once

#include "effort.h"
#include "knob.h"
#include "subject.h"

#include <functional>
#include <string>
#include <vector>

namespace raysteps {

// What the comparisons are made on.
struct KnobRequest {
    std::shared_ptr<const Subject> mesh;  // of the families of aimed rays
    std::shared_ptr<const Subject> scene; // with the camera that pictures are made by
    Effort effort;
};

// A comparison that can be asked for by its name.
struct KnobMaker {
    std::string name;
    std::function<Knob(const KnobRequest&)> make;
};

// All there are, in the order in which they are to be read.
const std::vector<KnobMaker>& knob_makers();

} // namespace raysteps
