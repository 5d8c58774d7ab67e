#pragma once

#include "mirror/mirror_scene.h"
#include "recorded_walk.h"
#include "structure/structure.h"
#include "told_walk.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// How often a walk came to a place, and how many triangles it tested: what the GPU's observer
// `count` counts (shaders/observer/count.glsl).
struct WalkCount {
    std::uint32_t visits = 0;
    std::uint32_t tests = 0;
};

// The walks of one structure, made by the mirror: the text that the GPU runs.
struct WalkRecorder {
    std::string structure;
    std::function<RecordedWalk(const Ray& ray, Question question)> record;
    std::function<std::vector<WalkCount>(std::span<const Ray> rays)> count; // on all cores; nearest
    // What a walk told of its steps means in this structure. A place that the structure does not
    // have is no_cell. Throws InputError where a triangle that it tests is not in the scene.
    std::function<RecordedWalk(const ToldWalk& told)> explain;
};

// What a recorder reads. Must outlive it.
struct RecorderInput {
    const mirror::SceneBuffers& scene;
    const PackedStructure& packed;
};

// The recorder of the walk NAME.glsl of shaders/structure. Throws InputError, with the names, where
// there is none.
WalkRecorder make_recorder(const std::string& structure, const RecorderInput& input);

// The names that make_recorder knows, sorted.
std::vector<std::string> recorded_structures();

} // namespace raysteps
