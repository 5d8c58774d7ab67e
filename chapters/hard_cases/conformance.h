#pragma once

#include "hard_cases/hard_case.h"
#include "reference/allowed_answers.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace raysteps {

// One family of the conformance suite (docs/conformance/README.md): hard cases for any ray tracer.
struct ConformanceFamily {
    std::string name;
    std::string tests; // what is hard
    std::string fails; // who goes wrong, and why
    AnswerRules::Origin origin = AnswerRules::Origin::anywhere;
    std::function<HardScene(const HardRequest&)> make;
    bool any_rays = false; // else only those of a usual length, from t_min 0 on
};

const std::vector<ConformanceFamily>& conformance_families();

// Writes the suite with about so many rays a family: NAME.obj, NAME.f32, NAME.answers and
// suite.json. The same request gives the same bytes.
void write_conformance_suite(const std::filesystem::path& folder, const HardRequest& request);

} // namespace raysteps
