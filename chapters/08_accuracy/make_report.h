#pragma once

#include "effort.h"
#include "program/options.h"

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
void refuse_window(const PictureOptions& picture);

// Of --size the smaller side, since pictures are square, and 8 pixels at least, which is what
// 08_accuracy/similarity.h looks at.
int side_of_pictures(const PictureSize& size);

// Measures, prints a table a knob, and writes accuracy.html, accuracy.csv, accuracy.json and the
// pictures to the folder of --out. Whether files can be written there, and the one of --json, is
// asked before any work; throws InputError where they cannot.
void make_report(const PictureOptions& picture, const ReportRequest& request);

} // namespace raysteps
