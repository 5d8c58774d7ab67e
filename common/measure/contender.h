#pragma once

#include "compare/contest.h"
#include "compare/ray_set.h"

#include <functional>
#include <string>
#include <vector>

namespace raysteps {

// Who takes part in one scene, whatever it is made of.
struct Contender {
    std::string name;
    std::vector<Fact> facts;
    std::function<void(const RaySet&)> run;                    // to its end
    std::function<std::size_t(const RaySet&)> count_different; // answers
};

// A walk through its structure. All that is given must outlive it.
Contender make_contender(const std::string& structure, TraceRays& walk, const SceneTextures& scene);

// Embree by single rays and by packets; nobody where the part is none.
std::vector<Contender> make_embree(const Scene& scene, EmbreePart part);

} // namespace raysteps
