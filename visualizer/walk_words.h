#pragma once

#include <array>

namespace raysteps::view {

// The words of files of recorded steps, which are written and read.
inline constexpr auto walk_schema = "walk.schema.json";
inline constexpr int walk_schema_version = 1;

// In the order of Outcome.
inline constexpr std::array outcome_words{"tested", "entered", "climbed", "emptied",
                                          "missed", "behind",  "touched", "leaf"};

// In the order of Question.
inline constexpr std::array question_words{"nearest", "any"};

} // namespace raysteps::view
