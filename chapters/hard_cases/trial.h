#pragma once

#include "gpu_methods.h"
#include "hard_cases/hard_case.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

enum class Verdict {
    pass,
    fail,
    reported, // nothing is promised: the figure tells how often the method goes wrong
};

// One line of the table: what one method made of one case.
struct TrialRow {
    std::string method;   // bvh_skip, or the name of a triangle test
    std::string where;    // C++ or GPU; empty where it is neither
    std::string expected; // in words
    std::string got;
    Verdict verdict = Verdict::pass;
    std::size_t tried = 0; // how many rays, or whatever was tried
    std::size_t wrong = 0;
};

inline constexpr int usual_rays = 10000;

// What a trial may use.
struct TrialTools {
    int rays = 0; // of each case; 0: the usual number of the case
    int seed = 1;
    GpuMethods* gpu = nullptr; // null where only C++ is tried
    bool by_mirror = true;
    std::string tree{}; // a file: only the walks that can go through it, and in none of our own
    Progress progress = [](double) {};
};

// A hard case by all methods that it concerns, or a check of its own.
struct Trial {
    std::string name;
    std::string title;
    std::string source;
    std::string remedy;
    std::function<std::vector<TrialRow>(const TrialTools& tools)> run;
};

// `101,637 of 1,000,000`
std::string to_words(std::size_t wrong, std::size_t tried);

// Pass where nothing is wrong, else fail.
Verdict verdict_of(std::size_t wrong);

// A row of counts with a promise: it passes where nothing is wrong.
TrialRow promised_row(const std::string& method, const std::string& where,
                      const std::string& expected, std::size_t wrong, std::size_t tried);

// A row of counts without one.
TrialRow reported_row(const std::string& method, const std::string& where,
                      const std::string& expected, std::size_t wrong, std::size_t tried);

// A trial and what came of it.
struct TrialResult {
    Trial trial;
    std::vector<TrialRow> rows;
};

enum class Colors { none, terminal };

// The lines of one trial for people, at most 100 columns wide: its name and title, then a line per
// method: name, where, expected, got, verdict. Methods with the same answer share a line.
std::string to_table(const TrialResult& result, Colors colors);

// A CSV file: a line of names, then a line per trial and method.
std::string to_csv(std::span<const TrialResult> results);

// How many rows have that verdict.
std::size_t count_rows(std::span<const TrialResult> results, Verdict verdict);

std::string to_words(Verdict verdict);

} // namespace raysteps
