#pragma once

#include "basics/ray.h"
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

// A plane that takes away what lies behind it, as seen along its normal.
struct ClipPlane {
    glm::vec3 point{0.0f};
    glm::vec3 normal{1.0f, 0.0f, 0.0f};
};

inline constexpr int last_step = -1;
inline constexpr int all_levels = -1;

// All that a picture of the visualizer depends on, and nothing else: options, keys, the mouse,
// saved files and tests only change this.
struct State {
    // What there is to see.
    std::string scene = "bunny";
    std::string hard_case;                              // instead of the scene: K3
    std::vector<std::string> structures{"bvh_ordered"}; // NAME or NAME:option=value:...
    std::map<std::string, std::string> build_values;    // for the builders of all of them
    std::optional<Camera> camera; // of the traced picture; the scene's where there is none
    glm::ivec2 picture{512, 512}; // its size in pixels

    // The ray: of a pixel of the picture, or as given.
    std::optional<glm::ivec2> pixel;
    std::optional<Ray> ray;
    int hard_ray = -1; // of the hard case's rays, where neither is given; the one that tells most
    int bounces = 4;
    int path_ray = 0;     // which of the rays behind the pixel; 0 is the one asked for
    int step = last_step; // from 0

    // How it is drawn.
    ModelStyle model = ModelStyle::transparent;
    CellFilter filter = CellFilter::occupied;
    CellColor color = CellColor::depth;
    int lowest_level = 0;
    int highest_level = all_levels;
    double opacity = 0.12; // of the faces of cells
    int most_cells = 20000;
    std::optional<ClipPlane> clip;
    HeatMap heat_map = HeatMap::none;
    bool table = false;
    SortBy sort_by = SortBy::cost;
    bool descending = true;
    int first_row = 0;
    int selected = -1; // a cell
    bool help = false;

    // From where.
    std::optional<Camera> viewpoint; // framed where there is none
    glm::ivec2 window{1280, 800};
};

} // namespace raysteps::view
