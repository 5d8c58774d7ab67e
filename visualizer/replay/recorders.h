#pragma once

#include "walk_recorder.h"

namespace raysteps {

// One for each file of shaders/structure.
WalkRecorder record_every_triangle(const RecorderInput& input);
WalkRecorder record_grid(const RecorderInput& input);
WalkRecorder record_grid_mailbox(const RecorderInput& input);
WalkRecorder record_kd_restart(const RecorderInput& input);
WalkRecorder record_kd_backtrack(const RecorderInput& input);
WalkRecorder record_kd_short_stack(const RecorderInput& input);
WalkRecorder record_kd_ropes(const RecorderInput& input);
WalkRecorder record_bvh_skip(const RecorderInput& input);
WalkRecorder record_bvh_skip_padded(const RecorderInput& input);
WalkRecorder record_bvh_ordered(const RecorderInput& input);
WalkRecorder record_bvh_parent(const RecorderInput& input);
WalkRecorder record_bvh_stack(const RecorderInput& input);

} // namespace raysteps
