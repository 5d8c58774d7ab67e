#pragma once

#include "program/deliver.h"
#include "claims.h"
#include "growth_lines.h"

namespace raysteps {

// All that a run found out.
struct Report {
    std::vector<SceneResult> results;
    std::vector<ClaimResult> claims;
    std::vector<GrowthLine> growth{};
    std::string renderer{};
    std::string embree{}; // its name; empty where it took no part
};

// For programs: per scene and kind of rays the rates of all contenders, the best walk of ours, and
// its ratio to Embree by single rays where that took part; then claims and growth.
nlohmann::ordered_json to_json(const Report& report);

} // namespace raysteps
