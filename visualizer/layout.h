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

// Where everything stands in the window.
struct Layout {
    std::vector<Area> panes;     // the structures in space, side by side
    std::vector<Area> heat_maps; // below them, as many, where there are heat maps
    Area side;                   // legend, facts or table
    Area bottom;                 // the steps in words
    Area step_slider;
    Area level_slider;
    Area opacity_slider;
    Area table; // its head and rows; without a table, of no size
};

inline constexpr int row_height = 20; // of the table
inline constexpr int margin = 14;

Layout layout_of(const State& state, std::size_t pane_count);

// Whether the ray is one of a hard case, which has a line at the bottom that says why.
bool has_note(const State& state);

// Rows of the table that are seen, the head not counted.
int table_rows(const Layout& layout);

// The picture of a heat map in its area: as large as it fits, in whole, at the area's middle.
Area picture_area(const Area& area, const glm::ivec2& picture);

} // namespace raysteps::view
