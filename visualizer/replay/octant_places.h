#pragma once

#include "structure/structure.h"

#include <unordered_map>

namespace raysteps {

// A node of a BVH lies once in each octant's order (shaders/structure/bvh/bvh_nodes.glsl). This finds its place
// in octant 0, for places asked in the order in which a walk comes to them: parents first.
class OctantPlaces {
public:
    // Must not outlive the structure.
    explicit OctantPlaces(const PackedStructure& packed);

    int in_first_octant(int place);

private:
    const PackedStructure& packed_;
    int count_;
    std::unordered_map<int, int> known_;
};

} // namespace raysteps
