#pragma once

#include "structure/bvh/bvh.h"
#include "structure/structure.h"

namespace raysteps {

StructureFamily family_bvh();

// What the family's builder is told, from a request's values; those of other families do not
// matter. Throws InputError where a value makes no sense.
BvhOptions bvh_options_of(const BuildRequest& request);

} // namespace raysteps
