#include "octant_places.h"

namespace raysteps {

OctantPlaces::OctantPlaces(const PackedStructure& packed)
    : packed_(packed), count_(packed.numbers.at("bvh_node_count")) {}

// An inner node makes its children known: the near one lies behind it, the far one is its second.
int OctantPlaces::in_first_octant(int place) {
    const int octant = place / count_;
    if (octant == 0) {
        return place;
    }
    const int here = place == octant * count_ ? 0 : known_.at(place);
    const std::vector<glm::ivec4>& nodes = packed_.integer_vectors.at("bvh_nodes");
    const int link = nodes[2 * static_cast<std::size_t>(place) + 1].w;
    if (link < 0) {
        const int first_link = nodes[2 * static_cast<std::size_t>(here) + 1].w;
        const int lower = here + 1;
        const int upper = (-1 - first_link) >> 2;
        const bool descends = (octant >> ((-1 - link) & 3) & 1) != 0;
        known_[place + 1] = descends ? upper : lower;
        known_[(-1 - link) >> 2] = descends ? lower : upper;
    }
    return here;
}

} // namespace raysteps
