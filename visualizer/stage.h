#pragma once

#include "hard_cases/hard_case.h"
#include "visualizer/replay/parting.h"
#include "visualizer/replay/recorded_path.h"
#include "visualizer/replay/structure_cells.h"
#include "visualizer/replay/walk_recorder.h"
#include "scene/scene.h"
#include "structure/structure.h"
#include "state.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace raysteps::view {

// A structure of the state, built, with the walks of the state's ray.
struct Pane {
    std::string label; // as the state names it
    std::string structure;
    BuiltStructure built;
    StructureCells cells;
    WalkRecorder recorder;
    std::vector<PathRay> path;      // empty where no ray is asked for
    std::vector<WalkCount> counted; // of each pixel, where there is a heat map
};

// What a state shows: scene, structures, walks. Loading and building take long, so a stage does
// only what the change of the state asks for.
class Stage {
public:
    // Called with what is about to be done: "building bvh_ordered".
    using Say = std::function<void(const std::string&)>;

    explicit Stage(Say say = [](const std::string&) {}) : say_(std::move(say)) {}

    // Throws InputError where the state asks for what there is not.
    void show(const State& state);

    const Scene& scene() const { return scene_; }
    const std::vector<std::unique_ptr<Pane>>& panes() const { return panes_; }
    const Camera& camera() const { return camera_; }  // of the traced picture
    const Box& bounds() const { return bounds_; }     // of the scene
    std::optional<Ray> ray() const { return ray_; }   // that is asked for
    const std::string& note() const { return note_; } // what makes the ray worth a look, or nothing

private:
    void load(const State& state);
    std::optional<Ray> ray_asked_for(const State& state) const;
    std::optional<Ray> hard_ray(const State& state);
    void build(const State& state);
    void record(const State& state);
    void count(const State& state);

    Say say_;
    std::optional<State> shown_;
    Scene scene_;
    Camera camera_;
    Box bounds_;
    float reach_ = 0.0f; // of the rays that the structures are built for
    std::optional<Ray> ray_;
    std::vector<Ray> hard_rays_; // of the hard case
    FamilyValues hard_values_;   // that its builders need
    std::string note_;
    std::unique_ptr<mirror::SceneBuffers> buffers_;
    std::vector<std::unique_ptr<Pane>> panes_;
};

// The walk of the state's ray, of those behind its pixel, in a pane; nullptr where there is none.
const RecordedWalk* walk_in(const Pane& pane, const State& state);

// The step of the state in that walk: 0 where it has none.
std::size_t step_in(const RecordedWalk& walk, const State& state);

// The most steps that any pane has for the state's ray.
int step_count(const Stage& stage, const State& state);

// Where the walks of the first two panes part; nothing where there are not two, or they never do.
std::optional<Parting> parting_of(const Stage& stage, const State& state);

} // namespace raysteps::view
