#pragma once

#include "effort.h"
#include "knob.h"
#include "subject.h"

namespace raysteps {

// What wrong hits look like: the rays of the subject's camera with each triangle test. The truth is
// the watertight test with exact areas. A context must be current.
Knob hit_picture_knob(const std::shared_ptr<const Subject>& subject, const Effort& effort);

} // namespace raysteps
