#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace raysteps {

// What a picture took, counted by the GPU (occlusion queries), and what it was spared.
struct RayTally {
    long camera = 0;
    long shadow = 0;       // to lights that are points
    long soft_shadow = 0;  // to points of lights with an area
    long behind_glass = 0; // shadow rays that went on behind glass
    long mirror = 0;
    long refracted = 0;          // or totally reflected
    long reflected_by_glass = 0; // the second ray at a hit

    long facing_away = 0;   // shadow rays that were not cast: the lamp is behind the surface
    long lamps_skipped = 0; // lamps that no surface of a bounce faces
    long faint = 0;         // rays that were not sent on: they would count too little
    int waves = 0;          // steps of the wavefront: traces of nearest hits
    int deepest = 0;        // bounces after which no path lived any more

    std::size_t most_listed = 0; // rays of the longest list behind glass
};

// The kinds of rays by name, as they are printed.
std::vector<std::pair<std::string, long>> kinds_of(const RayTally& tally);

long all_rays(const RayTally& tally);

} // namespace raysteps
