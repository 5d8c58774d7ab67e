#pragma once

#include "hard_cases/hard_case.h"
#include "scene/scene.h"
#include "state.h"
#include "structure/structure.h"
#include "visualizer/replay/recorded_path.h"
#include "visualizer/replay/structure_cells.h"
#include "visualizer/replay/walk_recorder.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace raysteps::view {

// A structure of the state, built, with the walks of the state's ray.
struct Pane {
    std::string label; // as the state names it: bvh_ordered:split=median; of a told walk its name
    std::string structure;
    BuiltStructure built;
    StructureCells cells;
    WalkRecorder recorder;
    std::vector<PathRay> path;      // empty where no ray is asked for
    std::vector<WalkCount> counted; // for each pixel, once a heat map was shown
};

// Called with what is about to be done: "building bvh_ordered".
using Say = std::function<void(const std::string&)>;

// What panes are built from. Scene and buffers must outlive them.
struct PaneSource {
    const Scene& scene;
    const mirror::SceneBuffers& buffers;
    float reach;                                            // of the rays (structure/padding.h)
    const std::map<std::string, std::string>& build_values; // for all builders that have them
    const FamilyValues& hard_values;                        // that a hard case needs
};

// A pane for each structure, which a state names as `bvh_ordered:split=median`, with builder
// options of its own, or by its family: `kd`. Throws InputError where there is no such structure,
// or its builder has no such option.
std::vector<std::unique_ptr<Pane>> build_panes(const std::vector<std::string>& structures,
                                               const PaneSource& source, const Say& say);

// The walk of the state's ray, or of that ray behind its pixel; nullptr where there is none.
const RecordedWalk* walk_in(const Pane& pane, const State& state);

// The step of the state in that walk: 0 where it has none.
std::size_t step_in(const RecordedWalk& walk, const State& state);

} // namespace raysteps::view
