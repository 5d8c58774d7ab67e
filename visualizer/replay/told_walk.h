#pragma once

#include "recorded_walk.h"

#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// What a walk itself said of a step.
struct ToldStep {
    int place = 0; // as the walk calls it
    int round = 0; // of one round each, in which it began; 0 where that is not known
    std::vector<int> tested;
    Hit nearest; // after the step
    std::optional<Outcome> outcome;
    std::optional<Box> box;
};

// A walk that was recorded elsewhere, and is held against ours: by a student's lines on the GPU, or
// by another program. visualizer/walk.schema.json is its file.
struct ToldWalk {
    std::string name;      // in pictures: yours
    std::string scene;     // as `view` takes it; empty where that is not known
    std::string structure; // as --structure takes it; or another program's own
    Ray ray;
    Question question = Question::nearest;
    std::vector<ToldStep> steps;
    bool ended = true;
    Hit hit;
};

// Whether it is a walk of shaders/structure, so that its places mean what ours mean.
bool is_walk_of_ours(const ToldWalk& told);

// The boxes that the walk tells of, where its structure is not ours: a cell for each place.
StructureCells told_cells(const ToldWalk& told);

// The walk in told_cells. `tests` is what the recorder of every_triangle makes of it.
RecordedWalk walk_in_told_cells(const ToldWalk& told, RecordedWalk tests);

} // namespace raysteps
