#pragma once

#include "11_paths/path_renderer.h"
#include "11_paths/path_sums.h"
#include "program/jobs.h"
#include "program/options.h"
#include "trace/trace_options.h"

#include <string>
#include <vector>

namespace raysteps {

// The options of chapter 11 besides those that all chapters share.
struct PathOptions {
    PathChoice choice;
    std::string samples{}; // empty: 64, or as many as --seconds and --error need
    double seconds = 0.0;
    double error = 0.0;
    float exposure = 0.0f;
    int samples_per_part = 64;
    JobOptions jobs;
};

void add_path_options(Options& options, PathOptions& paths);

// Which blocks to render: `64` is the first four, `64-127` the four after them. Throws InputError
// where it is neither, or does not begin and end with a block.
BlockRange blocks_of(const std::string& samples);

// Renders the scene until there are enough samples, or in a window until it is closed, and writes
// pictures, sums and figures. Throws Error with exit code 1 where a pixel was NaN or beyond all
// bounds, after it has written the rest.
void render_paths(const PictureOptions& picture, const TraceOptions& tracing,
                  const PathOptions& paths, Context& context, const Scene& scene);

// Writes a command for each part of the samples.
void write_path_jobs(const PathOptions& paths, const std::vector<std::string>& words);

// Joins what these commands have left: the bits of the whole.
void merge_paths(const PictureOptions& picture, const PathOptions& paths);

} // namespace raysteps
