#pragma once

#include "basics/ray.h"
#include "render/rays.h"
#include "scene/scene.h"

#include <span>
#include <string>
#include <vector>

namespace raysteps {

// What a ray wants to know: the nearest hit, or whether there is any.
enum class Query { closest, any };

struct RayKind {
    std::string name;
    Query query = Query::closest;
    std::vector<Ray> rays;
    Coherence coherence = Coherence::alone;
    std::vector<std::size_t> from{}; // the number of the primary ray that each ray comes from
};

// The rays that a renderer asks a structure for, as far as their coherence differs:
// primary, as given; shadow, from each hit to the scene's first light; reflection, from each hit as
// a mirror sends it on, as if all were mirrors; bounce, from each hit in a random direction over
// the surface, the more likely the steeper (so neighbours go apart). The hits are those of the
// primary rays. Kinds without a ray are left out.
std::vector<RayKind> ray_kinds(const Scene& scene, std::span<const Ray> primary,
                               std::span<const Hit> hits, int seed);

} // namespace raysteps
