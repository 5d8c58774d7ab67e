#pragma once

#include "basics/ray.h"
#include "scene/place_camera.h"
#include "scene/scene.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace raysteps::view {

enum class ModelStyle { transparent, wireframe, solid, hidden };
enum class CellFilter { occupied, visited, tested, all };
enum class CellColor { depth, triangles, cost, visits };
enum class HeatMap { none, visits, tests };
enum class SortBy { id, depth, count, area, cost };

// The words of a choice, in the order of its values: in options, in files and on the screen.
using Words = std::vector<std::string>;

inline Words words_of(ModelStyle) {
    return {"transparent", "wireframe", "solid", "hidden"};
}

inline Words words_of(CellFilter) {
    return {"occupied", "visited", "tested", "all"};
}

inline Words words_of(CellColor) {
    return {"depth", "triangles", "cost", "visits"};
}

inline Words words_of(HeatMap) {
    return {"none", "visits", "tests"};
}

inline Words words_of(SortBy) {
    return {"id", "depth", "count", "area", "cost"};
}

inline Words words_of(CameraChoice) {
    return camera_choices();
}

inline Words words_of(UpAxis) {
    return up_axes();
}

template <class Choice>
std::string word_of(Choice choice) {
    return words_of(choice)[static_cast<std::size_t>(choice)];
}

// The choice after this one; after the last, the first.
template <class Choice>
Choice next_of(Choice choice) {
    const std::size_t next = static_cast<std::size_t>(choice) + 1;
    return static_cast<Choice>(next % words_of(choice).size());
}

// A plane that hides what lies behind it, as seen along its normal.
struct ClipPlane {
    glm::vec3 point{0.0f};
    glm::vec3 normal{1.0f, 0.0f, 0.0f};
};

// Levels of a tree, both ends included; the root is level 0.
struct Levels {
    int lowest = 0;
    int highest = 0;
};

inline constexpr int last_step = -1;
inline constexpr int all_levels = -1;

// Everything that a picture of the visualizer depends on, and nothing else: options, keys, the
// mouse, saved files and tests only change this. Every field stands in state_fields.h as well.
struct State {
    // What there is to see.
    std::string scene = "bunny";
    int scale_exponent = 0; // all lengths of a file are multiplied by 2 to this power
    std::string hard_case;  // instead of the scene: K3
    std::vector<std::string> structures{"bvh4"};     // NAME or NAME:option=value:...
    std::map<std::string, std::string> build_values; // for the builders of all of them
    std::optional<Camera> camera; // that traces the picture; by default the scene's
    CameraChoice placed = CameraChoice::automatic; // without one, where a file names none
    UpAxis up = UpAxis::y;                         // the axis of a file that is up for it
    glm::ivec2 picture{512, 512};                  // its size in pixels

    // The ray: that of a pixel of the picture, as given, or that of recorded steps.
    std::optional<glm::ivec2> pixel;
    std::optional<Ray> ray;
    std::string steps; // a file of recorded steps: its ray, with that walk beside ours
    int hard_ray = -1; // which of the hard case's rays, if neither is given; -1: the most telling
    int bounces = 4;
    int path_ray = 0;      // which of the rays behind the pixel; 0 is the camera ray
    int step = last_step;  // from 0
    int why = no_triangle; // asks why the walk does not come to this one

    // How it is drawn.
    ModelStyle model = ModelStyle::transparent;
    CellFilter filter = CellFilter::occupied;
    CellColor color = CellColor::depth;
    Levels levels{0, all_levels};
    double opacity = 0.12; // of the faces of cells
    int most_cells = 20000;
    std::optional<ClipPlane> clip;
    HeatMap heat_map = HeatMap::none;
    bool own_scales = false; // of several heat maps; otherwise one for all
    bool table = false;
    SortBy sort_by = SortBy::cost;
    bool descending = true;
    int first_row = 0;
    int selected = -1; // a cell
    bool help = false;

    // From where.
    std::optional<Camera> viewpoint; // by default one that frames the scene
    glm::ivec2 window{1280, 800};
};

} // namespace raysteps::view
