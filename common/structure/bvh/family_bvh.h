#pragma once

#include "structure/bvh/bvh.h"
#include "structure/structure.h"

namespace raysteps {

StructureFamily family_bvh();

// What the family's builder is told, from a request's values; those of other families do not
// matter. Throws InputError where a value makes no sense.
BvhOptions bvh_options_of(const BuildRequest& request, const BvhOptions& defaults = {});

// The same of the family whose walks go through nodes of four children.
BvhOptions bvh4_options_of(const BuildRequest& request);

// The options of the builder, for a family that has defaults of its own.
std::vector<BuildOption> bvh_build_options(const BvhOptions& defaults);

// What is to be known of a tree over so many triangles, of its packed form, and of the seconds that
// building took.
std::vector<Fact> facts_of(const BvhMeasures& measures, std::size_t triangles,
                           const PackedStructure& packed, double seconds);

} // namespace raysteps
