#include "draw_table.h"

#include "visualizer/replay/sentence.h"
#include "visualizer/cell_choice.h"
#include "visualizer/colors.h"
#include "paint.h"

#include <algorithm>
#include <cstdio>

namespace raysteps::view {

namespace {

// With so few digits that it does not run into the next column.
std::string narrow_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value > 0.0 && value < 0.001 ? "%.1e" : "%.3g", value);
    return text;
}

void write_row(vtkRenderer& renderer, const Area& table, int row,
               const std::vector<std::string>& words, const Writing& writing) {
    const int y = table.y + table.height - (row + 1) * row_height + 5;
    const int width = (table.width - 2 * margin) / static_cast<int>(words.size());
    Writing right = writing;
    right.side = Side::right;
    for (std::size_t i = 0; i < words.size(); ++i) {
        write(renderer, words[i], {table.x + margin + width * static_cast<int>(i + 1), y}, right);
    }
}

std::vector<std::string> heads_of(const State& state) {
    std::vector<std::string> heads{"id", "depth", "count", "area", "cost"};
    std::string& sorted = heads[static_cast<std::size_t>(state.sort_by)];
    sorted = (state.descending ? "v " : "^ ") + sorted;
    return heads;
}

} // namespace

void draw_table(vtkRenderer& renderer, const Layout& layout, const Pane& pane, const State& state) {
    const Area& table = layout.table;
    write(renderer, pane.label + ": " + count_of(pane.cells.cells.size(), "cell"),
          {table.x + margin, table.y + table.height + 12}, {.size = 14, .font = Font::bold});
    write_row(renderer, table, 0, heads_of(state), {.size = 12, .font = Font::bold});
    const std::vector<int> order = sorted_cells(pane, state);
    for (int row = 0; row < table_rows(layout); ++row) {
        const auto place = static_cast<std::size_t>(std::max(state.first_row, 0) + row);
        if (place >= order.size()) {
            return;
        }
        const int number = order[place];
        const Cell& cell = pane.cells.cells[static_cast<std::size_t>(number)];
        const bool selected = number == state.selected;
        if (selected) {
            fill(renderer,
                 {table.x + 4, table.y + table.height - (row + 2) * row_height, table.width - 8,
                  row_height},
                 glm::mix(selected_color, glm::vec3(1.0f), 0.55f));
        }
        write_row(renderer, table, row + 1,
                  {std::to_string(number), std::to_string(cell.depth),
                   std::to_string(cell.triangles), narrow_number(area_of(cell)),
                   narrow_number(cell.cost)},
                  {.size = 12});
    }
}

} // namespace raysteps::view
