#include "basics/text.h"
#include "draw.h"

#include "paint.h"
#include "structure/bvh/bvh_split.h"
#include "visualizer/cell_choice.h"
#include "visualizer/color_scale.h"
#include "visualizer/replay/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace raysteps::view {

namespace {

constexpr int side_line = 20;

// A column of text that grows downwards.
struct Column {
    vtkRenderer& renderer;
    int x;
    int right;
    int y; // of the next line's base
};

void add_line(Column& column, const std::string& text, const Writing& writing) {
    write(column.renderer, text, {column.x, column.y}, writing);
    column.y -= side_line;
}

void add_heading(Column& column, const std::string& text) {
    column.y -= 6;
    add_line(column, text, {.size = 14, .font = Font::bold});
}

void add_fact(Column& column, const std::string& name, const std::string& value) {
    write(column.renderer, value, {column.right, column.y}, {.size = 13, .side = Side::right});
    add_line(column, name, {.color = faint_ink, .size = 13});
}

void add_swatch(Column& column, const glm::vec3& color, const std::string& text) {
    fill(column.renderer, {column.x, column.y + 1, 20, 9}, color);
    write(column.renderer, text, {column.x + 30, column.y}, {.size = 13});
    column.y -= side_line - 1;
}

void add_color_bar(Column& column, const Stage& stage, const State& state) {
    add_heading(column, "Cells: " + color_title(state.color));
    const ValueRange range = color_range(stage, state);
    constexpr int parts = 64;
    const int width = column.right - column.x;
    for (int i = 0; i < parts; ++i) {
        const int left = column.x + width * i / parts;
        fill(column.renderer, {left, column.y - 2, column.x + width * (i + 1) / parts - left, 14},
             color_in({0.0, parts - 1.0}, i));
    }
    column.y -= side_line - 1;
    const Writing small{.color = faint_ink, .size = 12};
    Writing middle = small;
    middle.side = Side::center;
    Writing right = small;
    right.side = Side::right;
    const auto number = [&](double value) { return short_number(number_of(state.color, value)); };
    write(column.renderer, number(0.5 * (range.lower + range.upper)),
          {(column.x + column.right) / 2, column.y}, middle);
    write(column.renderer, number(range.upper), {column.right, column.y}, right);
    add_line(column, number(range.lower), small);
}

void add_color_names(Column& column, const Stage& stage, const State& state) {
    const Pane& pane = *stage.panes().front();
    if (pane.path.empty()) {
        return;
    }
    add_heading(column, "The walk");
    add_swatch(column, current_color, "this step");
    add_swatch(column, culled_color, "left out (dashed)");
    add_swatch(column, {0.00f, 0.62f, 0.45f}, "the ray in leaves, in two tones");
    add_swatch(column, tested_color, "triangles tested");
    add_swatch(column, hit_color, "hit");
    add_heading(column, "Rays behind the pixel");
    const auto count = [&](RayRole role) {
        return std::count_if(pane.path.begin(), pane.path.end(),
                             [&](const PathRay& ray) { return ray.role == role; });
    };
    for (const auto& [role, name] : {std::pair{RayRole::camera, "camera"},
                                     {RayRole::shadow, "shadow"},
                                     {RayRole::mirror, "mirror"},
                                     {RayRole::refraction, "refracted"}}) {
        if (count(role) > 0) {
            add_swatch(column, color_of(role), std::to_string(count(role)) + " " + name);
        }
    }
    const int last = static_cast<int>(pane.path.size()) - 1;
    const auto shown = static_cast<std::size_t>(std::clamp(state.path_ray, 0, last));
    add_fact(column, "shown (Tab: the next)", ray_name(pane.path[shown]));
}

// Bytes and seconds get the largest unit that makes them at least 1.
std::string fact_value(const Fact& fact) {
    if (fact.name.ends_with("bytes")) {
        const int power = fact.value >= 1048576.0 ? 2 : fact.value >= 1024.0 ? 1 : 0;
        constexpr std::array<std::pair<const char*, double>, 3> units{
            {{" B", 1.0}, {" KiB", 1024.0}, {" MiB", 1048576.0}}};
        const auto [unit, bytes] = units[static_cast<std::size_t>(power)];
        return short_number(fact.value / bytes) + unit;
    }
    if (fact.name.ends_with("seconds")) {
        return fact.value >= 1.0 ? short_number(fact.value) + " s"
                                 : short_number(1000.0 * fact.value) + " ms";
    }
    return fact.value == static_cast<double>(static_cast<long long>(fact.value))
               ? std::to_string(static_cast<long long>(fact.value))
               : short_number(fact.value);
}

// Without the unit, which stands with the value.
std::string fact_name(const Fact& fact) {
    std::string name = fact.name;
    for (const std::string unit : {"_bytes", "_seconds"}) {
        if (name.ends_with(unit)) {
            name.resize(name.size() - unit.size());
        }
    }
    return spoken(name);
}

std::string corner_text(const glm::vec3& corner) {
    return fmt::format("{:.4g}, {:.4g}, {:.4g}", corner.x, corner.y, corner.z);
}

// Of the cell that is selected: where it is, what it is part of, and what it costs.
void add_selected(Column& column, const Pane& pane, int selected) {
    const std::vector<Cell>& cells = pane.cells.cells;
    if (selected < 0 || static_cast<std::size_t>(selected) >= cells.size()) {
        return;
    }
    const Cell& cell = cells[static_cast<std::size_t>(selected)];
    add_heading(column, "Selected: " + cell_name(pane.cells, selected));
    add_fact(column, "from", corner_text(cell.box.lower));
    add_fact(column, "to", corner_text(cell.box.upper));
    add_fact(column, "depth", std::to_string(cell.depth));
    add_fact(column, "triangles", std::to_string(cell.triangles));
    if (cell.parent != no_cell) {
        add_fact(column, "parent", cell_name(pane.cells, cell.parent));
    }
    std::string children;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].parent == selected) {
            children += (children.empty() ? "" : ", ") + std::to_string(i);
        }
    }
    if (!children.empty()) {
        add_fact(column, "children", children);
    }
    const double root = surface_area(cells.front().box);
    if (pane.cells.kind != CellKind::grid && root > 0.0) {
        add_fact(column, "is met by",
                 short_number(100.0 * surface_area(cell.box) / root) + " % of rays");
    }
    add_fact(column, "expected cost", short_number(cell.cost));
}

// One column of numbers for each structure, as many as there is room for, and a line for each fact.
void add_compared_facts(Column& column, const Stage& stage, int lowest) {
    constexpr std::size_t most = 3;
    constexpr int width = 62;
    const std::size_t count = std::min(stage.panes().size(), most);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) {
        const Pane& pane = *stage.panes()[i];
        add_fact(column, std::string(1, static_cast<char>('A' + i)), pane.label);
        for (const Fact& fact : pane.built.facts) {
            if (std::find(names.begin(), names.end(), fact.name) == names.end()) {
                names.push_back(fact.name);
            }
        }
    }
    // What most of them have comes first.
    std::stable_sort(names.begin(), names.end(), [&](const auto& a, const auto& b) {
        const auto have = [&](const std::string& name) {
            return std::count_if(stage.panes().begin(), stage.panes().end(), [&](const auto& pane) {
                const auto& facts = pane->built.facts;
                return std::any_of(facts.begin(), facts.end(),
                                   [&](const Fact& fact) { return fact.name == name; });
            });
        };
        return have(a) > have(b);
    });
    const auto right_of = [&](std::size_t i) {
        return column.right - width * static_cast<int>(count - 1 - i);
    };
    for (std::size_t i = 0; i < count; ++i) {
        write(column.renderer, std::string(1, static_cast<char>('A' + i)), {right_of(i), column.y},
              {.size = 13, .font = Font::bold, .side = Side::right});
    }
    column.y -= side_line;
    for (const std::string& name : names) {
        if (column.y < lowest) {
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            for (const Fact& fact : stage.panes()[i]->built.facts) {
                if (fact.name == name) {
                    write(column.renderer, fact_value(fact), {right_of(i), column.y},
                          {.size = 12, .side = Side::right});
                }
            }
        }
        const std::string words = fact_name({name, 0.0});
        const int room = right_of(0) - width - column.x;
        add_line(column, words, {.color = faint_ink, .size = size_to_fit(words, room, 12)});
    }
}

void add_facts(Column& column, const Stage& stage, int lowest) {
    if (stage.panes().size() > 1) {
        add_heading(column, "Structures");
        add_compared_facts(column, stage, lowest);
        return;
    }
    for (const std::unique_ptr<Pane>& pane : stage.panes()) {
        if (pane->built.facts.empty() || column.y - 3 * side_line < lowest) {
            continue;
        }
        add_heading(column, pane->label);
        for (const Fact& fact : pane->built.facts) {
            if (column.y < lowest) {
                break;
            }
            add_fact(column, fact_name(fact), fact_value(fact));
        }
    }
}

struct SliderValues {
    double from = 0.0; // fractions of the slider's width
    double to = 1.0;
    std::string name;
    std::string value;
};

void draw_slider(vtkRenderer& renderer, const Area& area, const SliderValues& values) {
    write(renderer, values.name, {area.x, area.y + area.height + 6}, {.size = 13});
    write(renderer, values.value, {area.x + area.width, area.y + area.height + 6},
          {.size = 13, .side = Side::right});
    fill(renderer, area, rule_color);
    const int left = area.x + static_cast<int>(values.from * area.width);
    const int right = area.x + static_cast<int>(values.to * area.width);
    fill(renderer, {left, area.y, std::max(right - left, 3), area.height},
         color_of(RayRole::camera));
}

std::string levels_text(const Stage& stage, const State& state,
                        const std::vector<DrawnPane>& drawn) {
    const Levels levels = levels_of(*stage.panes().front(), state);
    const long boxes = drawn.front().cells;
    const long all = boxes + drawn.front().left_out;
    return std::to_string(levels.lowest) + " to " + std::to_string(levels.highest) + " of " +
           std::to_string(stage.panes().front()->cells.deepest) + ", " +
           (boxes < all ? std::to_string(boxes) + " of " : "") + std::to_string(all) +
           (all == 1 ? " box" : " boxes");
}

// With few enough digits not to run into the next column.
std::string narrow_number(double value) {
    return value > 0.0 && (value < 0.001 || value >= 10000.0) ? fmt::format("{:.1e}", value)
                                                              : fmt::format("{:.3g}", value);
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

Words heads_of(const State& state) {
    Words heads = words_of(state.sort_by);
    std::string& sorted = heads[static_cast<std::size_t>(state.sort_by)];
    sorted = (state.descending ? "v " : "^ ") + sorted;
    return heads;
}

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
                   std::to_string(cell.triangles), narrow_number(surface_area(cell.box)),
                   narrow_number(cell.cost)},
                  {.size = 12});
    }
}

} // namespace

void draw_side(vtkRenderer& renderer, const Layout& layout, const Stage& stage, const State& state,
               const std::vector<DrawnPane>& drawn) {
    const Area& side = layout.side;
    Column column{renderer, side.x + margin, side.x + side.width - margin,
                  side.y + side.height - 24};
    const int lowest = layout.level_slider.y + 46;
    if (state.table) {
        draw_table(renderer, layout, *stage.panes().front(), state);
    } else {
        add_color_bar(column, stage, state);
        add_color_names(column, stage, state);
        add_selected(column, *stage.panes().front(), state.selected);
        add_facts(column, stage, lowest);
    }
    const Levels levels = levels_of(*stage.panes().front(), state);
    const double count = stage.panes().front()->cells.deepest + 1.0;
    draw_slider(renderer, layout.level_slider,
                {levels.lowest / count, (levels.highest + 1) / count, "levels",
                 levels_text(stage, state, drawn)});
    draw_slider(renderer, layout.opacity_slider,
                {0.0, state.opacity, "opacity of cells", short_number(state.opacity)});
}

} // namespace raysteps::view
