#pragma once

#include "structure/bvh/bvh.h"
#include "structure/structure.h"

namespace raysteps {

StructureFamily family_bvh();

// What the family's builder is told, from a request's values; those of other families do not
// matter. Throws InputError where a value makes no sense.
BvhOptions bvh_options_of(const BuildRequest& request);

// What is to be known of a tree, of its packed form, and of the seconds that building took.
std::vector<Fact> facts_of(const Bvh& bvh, const BvhOptions& options, const PackedStructure& packed,
                           double seconds);

} // namespace raysteps
