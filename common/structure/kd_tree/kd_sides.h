#pragma once

#include "structure/kd_events.h"
#include "structure/kd_plane.h"

#include <cstdint>
#include <vector>

namespace raysteps {

enum class Sides : std::uint8_t { both, lower, upper };

// On which sides of the plane each triangle of a node has a part. The vector has a place for each
// triangle of the scene and is used again, since only those of the node matter.
std::vector<Sides> sorted_out(std::vector<Sides> sides, const KdEvents& events,
                              const KdPlane& plane);

// The events of the triangles with those sides, still sorted.
KdEvents events_on(Sides side, const KdEvents& events, const std::vector<Sides>& sides);

// The triangles with those sides, each once.
std::vector<int> triangles_on(Sides side, const KdEvents& events, const std::vector<Sides>& sides);

} // namespace raysteps
