#pragma once

#include "render/rays.h"
#include "render/scene_textures.h"

#include <functional>
#include <string>

namespace raysteps {

// Whether rays that are neighbours are traced four at once, where there is a walk for packets.
enum class Packets { never, where_faster, always };

// From so many rays on, packets may be faster. Those of 512 x 512 rays lie in 16 of the tiles of
// 64 x 64 fragments that Mesa's llvmpipe hands to its threads, and a thread that has no tile does
// nothing: with fewer than two for each processor, rays by themselves come to their end sooner.
long least_rays_for_packets();

// Whether packets are faster on this machine: measured once, when it is asked first. They share
// their fetches, which are most of the work of a processor, and are a quarter of the threads, which
// a GPU may not like; no name of a renderer says which counts for more. `trace` traces a batch one
// way or the other, to its end, through the structure of that name.
using TraceBatch = std::function<void(const RayTextures&, const SceneTextures&, Packets)>;
bool packets_are_faster(const std::string& structure, const TraceBatch& trace);

} // namespace raysteps
