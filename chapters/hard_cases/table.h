#pragma once

#include "program/deliver.h"
#include "trial.h"

#include <span>
#include <string>

namespace raysteps {

// A trial and what came of it.
struct TrialResult {
    Trial trial;
    std::vector<TrialRow> rows;
};

enum class Colors { none, terminal };

// The lines of one trial for people, at most 100 columns wide: its name and title, then a line a
// method: name, where, expected, got, verdict. Methods with the same answer share a line.
std::string to_table(const TrialResult& result, Colors colors);

// For programs: a line of names, then a line a trial and method.
std::string to_csv(std::span<const TrialResult> results);
nlohmann::ordered_json to_json(std::span<const TrialResult> results);

// How many rows have that verdict.
std::size_t count_rows(std::span<const TrialResult> results, Verdict verdict);

std::string to_words(Verdict verdict);

} // namespace raysteps
