#pragma once

#include "measure/scene_costs.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

enum class ClaimVerdict { holds, does_not_hold, ranges_overlap };

// `holds`, `does not hold`, `ranges overlap`
std::string to_words(ClaimVerdict verdict);

// One scene for or against a claim, with the numbers that decide.
struct ClaimCase {
    std::string scene;
    ClaimVerdict verdict = ClaimVerdict::ranges_overlap;
    std::string numbers;
};

// A claim of the paper, judged by the rays of one kind.
struct ClaimResult {
    std::string claim;
    std::string kind;
    ClaimVerdict verdict = ClaimVerdict::ranges_overlap;
    std::vector<ClaimCase> cases{};
};

// The kinds of rays, in the order in which they first appear.
std::vector<std::string> kinds_of(std::span<const SceneCosts> results);

// The fastest walk of a family (`kd` of kd_restart, kd_ropes ...) for rays of a kind; nothing where
// none took part.
std::optional<RayCosts> best_of_family(const SceneCosts& result, const std::string& kind,
                                       const std::string& family);

// Whether a scene is the exception that the paper makes for the grid: a single object, neither
// dense knots nor surroundings.
bool is_single_object(const std::string& scene);

// What the paper concludes of speed, each for each kind of rays. Families are compared by their
// fastest walks, scene by scene; where the ranges of rounds overlap, a scene decides nothing.
// - The grid is the slowest, except for a scene of a single object.
// - For most scenes, the kd-tree is faster than the grid: more than half of those that decide.
// - The BVH is faster than the grid and the kd-tree.
// The first and the last do not hold where a single scene says so. Where no scene decides, or a
// family took no part, the verdict is that ranges overlap.
// Source: Wang and Wen, "Research of Acceleration Structures for GPU Based Ray Tracing", 2010,
// conclusion.
std::vector<ClaimResult> judge_speed(std::span<const SceneCosts> results);

// A walk, and how many lines of GLSL it needs over those of the loop over every triangle: those of
// all files that its program includes and that loop's does not, without comments and empty lines.
// The builders are not counted.
struct ProgramLength {
    std::string structure;
    int lines = 0;
};

// Throws InputError where there is no such structure.
ProgramLength program_length(const std::string& structure);

// And of simplicity: the BVH is the simplest, by the shortest program of each family.
ClaimResult judge_simplicity(std::span<const ProgramLength> programs);

} // namespace raysteps
