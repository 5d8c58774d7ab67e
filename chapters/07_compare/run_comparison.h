#pragma once

#include "measure/built_structures.h"
#include "program/jobs.h"
#include "reference/embree/embree.h"
#include "trace/trace_options.h"

#include <string>
#include <vector>

namespace raysteps {

struct Comparison {
    std::vector<std::string> scenes{"compact", "knot", "stadium", "cornell_box", "bunny"};
    std::vector<StructureChoice> structures = plain_structures(
        {"grid", "grid_mailbox", "kd_restart", "kd_backtrack", "kd_short_stack", "kd_ropes",
         "bvh_skip", "bvh_ordered", "bvh_parent", "bvh_stack", "bvh4", "packet_bvh4"});
    int growth = 3; // the depth of the largest sphereflake; -1: none
    int rounds = 5;
    double most_seconds = 0.2;
    std::string embree = "auto";
    EmbreePart embree_part = EmbreePart::none;
    std::filesystem::path against{}; // the JSON of an earlier run; empty: none
    JobOptions jobs{};
};

// Measures all structures in all scenes, prints tables and verdicts, and writes compare.csv,
// compare.json and the plots to the folder of --out, and the JSON to the file of --json as well.
// With --against, compares with the earlier run, and throws Error with exit code 1 where a walk is
// slower than then beyond doubt.
void run_comparison(const PictureOptions& picture, const TraceOptions& tracing,
                    const Comparison& comparison);

// A command for each scene (program/jobs.h); the words are those of this command line.
void write_comparison_jobs(const Comparison& comparison, const std::vector<std::string>& words);

// The same report of what these commands measured, with its files. Throws Error with exit code 1
// where parts are missing.
void merge_comparison(const PictureOptions& picture, const Comparison& comparison);

} // namespace raysteps
