#pragma once

#include "program/jobs.h"
#include "program/options.h"
#include "trade_off.h"

#include <string>
#include <vector>

namespace raysteps {

struct ReportRequest {
    Effort effort{};
    std::vector<std::string> trade_offs{}; // all where none is named
    int seed = 1;
    int rounds = 9;
    bool own_scene = false; // aim the families of rays at the scene, not at the usual sphere
    JobOptions jobs{};
};

// That of --full.
Effort full_effort();

// The names that --trade-offs takes.
std::string trade_off_names();

// The report is a page: throws InputError where --window was given.
void refuse_window(const PictureOptions& picture);

// The smaller side of --size, since pictures are square, and 8 pixels at least, the window in which
// 08_accuracy/judges.h compares them.
int side_of_pictures(const PictureSize& size);

// Measures, prints a table per trade-off, and writes accuracy.json, accuracy.csv and the pictures
// to the folder of --out; then scripts/accuracy_page makes accuracy.html of them. Checks before any
// work whether files can be written there, and the one of --json; throws InputError where they
// cannot, and MachineError where there is no Python to make the page.
void make_report(const PictureOptions& picture, const ReportRequest& request);

// A command for each trade-off (program/jobs.h); the words are those of this command line.
void write_report_jobs(const ReportRequest& request, const std::vector<std::string>& words);

// The same files of what these commands measured. Throws Error with exit code 1 where parts are
// missing.
void merge_report(const PictureOptions& picture, const ReportRequest& request);

} // namespace raysteps
