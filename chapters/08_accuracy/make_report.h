#pragma once

#include "accuracy/effort.h"
#include "command/command.h"

#include <string>
#include <vector>

namespace raysteps {

struct ReportRequest {
    Effort effort{};
    std::vector<std::string> knobs{}; // all where none is named
    int seed = 1;
    int rounds = 9;
    bool own_scene = false; // aim the families of rays at the scene, not at the usual sphere
};

// That of --full.
Effort full_effort();

// The names that --knobs takes.
std::string knob_names();

// The report is a page: throws InputError where --window was given.
void refuse_window(const Command& command);

// Measures, prints a table a knob, and writes accuracy.html, accuracy.csv, accuracy.json and the
// pictures to the folder of --out.
void make_report(const Command& command, const ReportRequest& request);

} // namespace raysteps
