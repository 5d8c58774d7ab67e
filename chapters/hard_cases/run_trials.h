#pragma once

#include "program/command.h"

namespace raysteps {

// What a person asks of the program.
struct TrialRequest {
    std::string name; // of one case; empty for all
    bool list = false;
    int rays = 0; // 0: as many as is usual
    bool is_long = false;
    double fuzz_seconds = 0.0;
    int seed = 1;
    std::string by = "both";
    std::filesystem::path csv;
};

// Runs the trials and prints their table. Throws Error with exit code 1 where a promise is broken.
void run_trials(const Command& command, const TrialRequest& request);

} // namespace raysteps
