#pragma once

#include "claims.h"
#include "measure/contest.h"

#include <span>
#include <string>

namespace raysteps {

// For people: what each contender took to build, then one line a kind and contender. A star marks
// rates of a part of the rays.
std::string to_table(const SceneResult& result);

// For programs: a line of names, then one line a scene, contender and kind.
std::string to_csv(std::span<const SceneResult> results);

// The verdicts, each with its cases and numbers.
std::string to_table(std::span<const ClaimResult> claims);

} // namespace raysteps
