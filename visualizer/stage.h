#pragma once

#include "pane.h"
#include "visualizer/replay/parting.h"
#include "visualizer/replay/told_walk.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raysteps::view {

// One of a hard case's rays, and which usual method it breaks, in words.
struct HardRay {
    std::size_t number = 0;
    std::string why;
};

// What a state shows: scene, structures, walks. Loading and building take long, so each of them
// remembers what it was made from, and a stage does again only what the state changes.
class Stage {
public:
    explicit Stage(Say say = [](const std::string&) {}) : say_(std::move(say)) {}

    // Throws InputError where the state asks for something that does not exist.
    void show(const State& state);

    const Scene& scene() const { return scene_; }
    const std::vector<std::unique_ptr<Pane>>& panes() const { return panes_; }
    const mirror::SceneBuffers& buffers() const { return *buffers_; }
    const Camera& camera() const { return camera_; }  // of the traced picture
    const Box& bounds() const { return bounds_; }     // of the scene
    std::optional<Ray> ray() const { return ray_; }   // of the state
    const std::string& note() const { return note_; } // why the ray is worth a look; may be empty

private:
    struct SceneSource {
        std::string scene;
        std::string hard_case;
        float aspect_ratio;
        int scale_exponent;
        CameraChoice placed;
        UpAxis up;

        bool operator==(const SceneSource&) const = default;
    };

    struct StructureSource {
        std::vector<std::string> structures;
        std::map<std::string, std::string> build_values;
        float reach;       // of the rays that the structures are built for
        std::string steps; // a file of recorded steps, or empty

        bool operator==(const StructureSource&) const = default;
    };

    struct PathSource {
        std::optional<Ray> ray;
        int bounces;
        std::string steps;

        bool operator==(const PathSource&) const;
    };

    struct CountSource {
        Camera camera;
        glm::ivec2 picture;

        bool operator==(const CountSource&) const;
    };

    void check_sought(const State& state) const;
    void tell(const std::string& steps);
    void load(const SceneSource& source, const std::optional<Camera>& camera);
    void build(const StructureSource& source);
    void record_told();
    void record(const PathSource& source);
    void count(const CountSource& source);
    float reach_with(const std::optional<Ray>& ray) const;
    std::optional<Ray> ray_of(const State& state) const;
    std::optional<Ray> hard_ray(const State& state);

    Say say_;

    std::optional<SceneSource> loaded_;
    Scene scene_;
    Box bounds_;
    std::unique_ptr<mirror::SceneBuffers> buffers_;
    std::vector<Ray> hard_rays_; // of the hard case
    FamilyValues hard_values_;   // that its builders need

    Camera camera_;

    std::string told_file_;
    std::optional<ToldWalk> told_; // of that file; its pane is the first

    std::optional<StructureSource> built_;
    std::vector<std::unique_ptr<Pane>> panes_;
    std::optional<HardRay> most_telling_; // of the hard rays, in these structures

    std::optional<PathSource> recorded_;
    std::optional<Ray> ray_;
    std::string note_;

    std::optional<CountSource> counted_;
};

// The most steps that any pane has for the state's ray.
int step_count(const Stage& stage, const State& state);

// Where the walks of the first two panes part; nothing where there are not two, or they never do.
std::optional<Parting> parting_of(const Stage& stage, const State& state);

} // namespace raysteps::view
