#include "layout.h"

#include <algorithm>

namespace raysteps::view {

namespace {

constexpr int side_width = 320;
constexpr int line_height = 22;
constexpr int slider_height = 14;

Area slider_in_side(const Area& side, int y) {
    return {side.x + margin, y, side.width - 2 * margin, slider_height};
}

} // namespace

Layout layout_of(const State& state, std::size_t pane_count) {
    const int panes = std::max(static_cast<int>(pane_count), 1);
    // A slider, and below it a sentence and a line of the shader for each walk.
    const int bottom_height = 2 * margin + slider_height + 2 * line_height * panes +
                              (panes > 1 ? line_height : 0) + (has_note(state) ? line_height : 0);
    Layout layout;
    const int side = std::min(side_width, state.window.x / 2);
    const int main_width = state.window.x - side;
    const int main_height = std::max(state.window.y - bottom_height, 1);
    layout.bottom = {0, 0, state.window.x, bottom_height};
    layout.side = {main_width, bottom_height, side, main_height};
    layout.step_slider = {margin, bottom_height - slider_height - 6, state.window.x - 2 * margin,
                          slider_height};
    layout.opacity_slider = slider_in_side(layout.side, bottom_height + 12);
    layout.level_slider = slider_in_side(layout.side, bottom_height + 58);
    const bool has_maps = state.heat_map != HeatMap::none;
    const int map_height = has_maps ? main_height * 48 / 100 : 0;
    for (int i = 0; i < panes; ++i) {
        const int left = main_width * i / panes;
        const int right = main_width * (i + 1) / panes;
        layout.panes.push_back(
            {left, bottom_height + map_height, right - left, main_height - map_height});
        if (has_maps) {
            layout.heat_maps.push_back({left, bottom_height, right - left, map_height});
        }
    }
    if (state.table) {
        const int low = layout.level_slider.y + 50;
        const int rows = std::max((layout.side.y + layout.side.height - 40 - low) / row_height, 1);
        layout.table = {layout.side.x, low, layout.side.width, rows * row_height};
    }
    return layout;
}

bool has_note(const State& state) {
    return !state.hard_case.empty() && !state.pixel && !state.ray;
}

int table_rows(const Layout& layout) {
    return std::max(layout.table.height / row_height - 1, 0);
}

int histogram_width(const Area& area) {
    return std::clamp(area.width / 4, 30, 170);
}

Area picture_area(const Area& area, const glm::ivec2& picture) {
    // The title stands above, the histogram to the right.
    const int room_x = std::max(area.width - 2 * margin - histogram_width(area) - 20, 1);
    const int room_y = std::max(area.height - 2 * margin - 20, 1);
    const double scale =
        std::min(static_cast<double>(room_x) / picture.x, static_cast<double>(room_y) / picture.y);
    const int width = std::max(static_cast<int>(picture.x * scale), 1);
    const int height = std::max(static_cast<int>(picture.y * scale), 1);
    return {area.x + margin, area.y + margin + (room_y - height) / 2, width, height};
}

} // namespace raysteps::view
