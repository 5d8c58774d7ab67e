#pragma once

#include "scene/scene.h"

namespace raysteps {

// A ball with nine smaller balls on it, which have nine balls each, and so on `depth` times, over a
// floor: the "balls" of Haines, "A proposal for standard graphics environments", 1987.
// The first ball has 1,280 triangles, each of the next nine 320, all smaller ones 80.
Scene sample_sphereflake(int depth);

} // namespace raysteps
