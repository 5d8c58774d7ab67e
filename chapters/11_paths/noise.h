#pragma once

#include "11_paths/run_paths.h"

namespace raysteps {

// What --noise compares, and against what.
struct NoiseRequest {
    bool measure = false;
    int reference_samples = 16384;
    double wanted_error = 0.02; // the advice is for this part of the mean
};

void add_noise_options(Options& options, NoiseRequest& request);

// The error of each idea, switched by itself, against its samples and its seconds; the picture of
// all ideas, by another seed and with many samples, is the truth. Prints a table with the slopes
// and what to take, and draws `noise.png`.
void measure_noise(const PictureOptions& picture, const TraceOptions& tracing,
                   const PathOptions& paths, const NoiseRequest& request, const Scene& scene);

} // namespace raysteps
