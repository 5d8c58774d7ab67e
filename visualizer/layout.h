#pragma once

#include "state.h"

#include <cstddef>
#include <vector>

namespace raysteps::view {

// A part of the window in pixels; (0, 0) is the window's lower left corner.
struct Area {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

inline bool holds(const Area& area, const glm::ivec2& place) {
    return place.x >= area.x && place.y >= area.y && place.x < area.x + area.width &&
           place.y < area.y + area.height;
}

// Where everything is in the window.
struct Layout {
    std::vector<Area> panes;     // the structures in space, side by side
    std::vector<Area> heat_maps; // one below each pane; empty without heat maps
    Area side;                   // legend, facts or table
    Area bottom;                 // the steps, in sentences
    Area step_slider;
    Area level_slider;
    Area opacity_slider;
    Area table; // header and rows; of size 0 without a table
};

inline constexpr int row_height = 20; // of the table
inline constexpr int margin = 14;

Layout layout_of(const State& state, std::size_t pane_count);

// Whether the ray comes from a hard case: then a line at the bottom says why it was chosen.
bool has_note(const State& state);

// How many rows of the table are visible, not counting its header.
int table_rows(const Layout& layout);

// Of the bars beside the picture of a heat map in that area.
int histogram_width(const Area& area);

// Where the picture of a heat map goes in its area: as large as fits, centred vertically.
Area picture_area(const Area& area, const glm::ivec2& picture);

} // namespace raysteps::view
