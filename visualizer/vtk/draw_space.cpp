#include "draw.h"

#include "paint.h"
#include "structure/bvh/bvh_split.h"
#include "visualizer/cell_choice.h"
#include "visualizer/color_scale.h"
#include "visualizer/replay/sentence.h"
#include "visualizer/why.h"

#include <vtkNew.h>

#include <algorithm>

namespace raysteps::view {

namespace {

// Beyond these limits, the faces of boxes only hide each other, and each layer takes time to blend.
constexpr std::size_t most_faces = 3000;
constexpr double most_layers = 60.0; // total surface, in surfaces of the largest box

vtkSmartPointer<vtkPlane> clipping_plane(const State& state) {
    if (!state.clip) {
        return nullptr;
    }
    const ClipPlane& clip = *state.clip;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(clip.point.x, clip.point.y, clip.point.z);
    plane->SetNormal(clip.normal.x, clip.normal.y, clip.normal.z);
    return plane;
}

void draw_model(vtkRenderer& renderer, const SpaceInput& input, vtkPlane* clip) {
    Look look{.color = model_color, .shaded = true, .clip = clip};
    switch (input.state.model) {
    case ModelStyle::hidden:
        return;
    case ModelStyle::transparent:
        look.opacity = 0.22;
        break;
    case ModelStyle::wireframe:
        look.wireframe = true;
        look.shaded = false;
        look.opacity = 0.35;
        break;
    case ModelStyle::solid:
        break;
    }
    if (input.model->GetNumberOfCells() > 0) {
        add_shape(renderer, input.model, look);
    }
}

// The part of a kd-tree node's split plane that lies in its box.
Rectangle split_plane(const Cell& cell) {
    const int u = (cell.axis + 1) % 3;
    const int v = (cell.axis + 2) % 3;
    Rectangle plane{cell.box.lower, glm::vec3(0.0f), glm::vec3(0.0f)};
    plane.corner[cell.axis] = cell.split;
    plane.side[u] = cell.box.upper[u] - cell.box.lower[u];
    plane.other_side[v] = cell.box.upper[v] - cell.box.lower[v];
    return plane;
}

struct DrawnCells {
    long boxes = 0;
    long planes = 0;
    long left_out = 0;
};

double layers_of(const std::vector<Box>& boxes) {
    double sum = 0.0;
    double largest = 0.0;
    for (const Box& box : boxes) {
        const double area = surface_area(box);
        sum += area;
        largest = std::max(largest, area);
    }
    return largest > 0.0 ? sum / largest : 0.0;
}

DrawnCells draw_cells(vtkRenderer& renderer, const SpaceInput& input, vtkPlane* clip) {
    const Pane& pane = *input.stage.panes()[input.pane];
    const CellChoice choice = choose_cells(pane, input.state);
    const std::vector<double> values = color_values(pane, input.state, choice.cells);
    const ValueRange range = color_range(input.stage, input.state);
    std::vector<Box> boxes;
    std::vector<Rectangle> planes;
    std::vector<double> plane_values;
    for (std::size_t i = 0; i < choice.cells.size(); ++i) {
        const Cell& cell = pane.cells.cells[static_cast<std::size_t>(choice.cells[i])];
        boxes.push_back(cell.box);
        if (cell.axis != no_axis) {
            planes.push_back(split_plane(cell));
            plane_values.push_back(values[i]);
        }
    }
    DrawnCells drawn;
    drawn.left_out = static_cast<long>(choice.left_out);
    if (boxes.empty()) {
        return drawn;
    }
    const bool few = boxes.size() <= 200;
    const Shape edges = box_edges(boxes, values);
    add_valued_shape(renderer, edges,
                     {.opacity = few ? 0.95 : 0.7, .width = few ? 1.8f : 1.0f, .clip = clip},
                     range);
    drawn.boxes = static_cast<long>(edges->GetNumberOfCells()) / 12;
    if (input.state.why >= 0) { // what is red must be seen through all boxes around it
        return drawn;
    }
    if (!planes.empty() && planes.size() <= most_faces && input.state.opacity > 0.0) {
        const Shape filled = rectangles(planes, plane_values);
        add_valued_shape(renderer, filled, {.opacity = input.state.opacity, .clip = clip}, range);
        drawn.planes = static_cast<long>(filled->GetNumberOfCells());
    } else if (boxes.size() <= most_faces && input.state.opacity > 0.0 &&
               layers_of(boxes) <= most_layers) {
        add_valued_shape(renderer, box_faces(boxes, values),
                         {.opacity = input.state.opacity * (few ? 0.6 : 0.25), .clip = clip},
                         range);
    }
    return drawn;
}

void draw_selected(vtkRenderer& renderer, const SpaceInput& input) {
    const Pane& pane = *input.stage.panes()[input.pane];
    const auto number = static_cast<std::size_t>(input.state.selected);
    if (input.state.selected < 0 || number >= pane.cells.cells.size()) {
        return;
    }
    const std::vector<Box> box{pane.cells.cells[number].box};
    add_shape(renderer, box_edges(box), {.color = selected_color, .width = 3.5f});
    add_shape(renderer, box_faces(box), {.color = selected_color, .opacity = 0.18});
}

// The triangle that is missed, and the box that left it out.
void draw_why(vtkRenderer& renderer, const SpaceInput& input) {
    const auto why = input.pane == 0 ? why_of(input.stage, input.state) : std::nullopt;
    if (!why) {
        return;
    }
    const Shape triangle = triangles(why->corners);
    add_shape(renderer, triangle, {.color = warning_ink});
    add_shape(renderer, triangle, {.color = ink, .width = 2.5f, .wireframe = true});
    if (why->box) {
        const std::vector<Box> box{*why->box};
        add_shape(renderer, box_edges(box), {.color = warning_ink, .width = 3.5f});
        add_shape(renderer, box_faces(box), {.color = warning_ink, .opacity = 0.12});
    }
}

std::string title_of(const SpaceInput& input) {
    const Pane& pane = *input.stage.panes()[input.pane];
    const RecordedWalk* walk = walk_in(pane, input.state);
    const auto all = static_cast<std::size_t>(triangle_count(input.stage.scene()));
    const auto drawn = static_cast<std::size_t>(input.model->GetNumberOfCells());
    const std::string some =
        drawn < all ? std::to_string(drawn) + " of " + count_of(all, "triangle") + " drawn" : "";
    if (!pane.refusal.empty()) {
        return "Only its boxes are shown: " + pane.refusal;
    }
    if (!walk) {
        return input.stage.scene().name + ", " + (some.empty() ? count_of(all, "triangle") : some);
    }
    return count_of(walk->steps.size(), "step") + ", " +
           count_of(walk->tests.size(), "triangle test") + (some.empty() ? "" : " (" + some + ")") +
           "\n" + ending_of(*walk);
}

void write_title(vtkRenderer& renderer, const Area& area, const SpaceInput& input) {
    const Pane& pane = *input.stage.panes()[input.pane];
    const int top = area.y + area.height;
    const int width = (area.width - 2 * margin) * 9 / 10; // digits are wider than letters
    write(renderer, pane.label, {area.x + margin, top - 28},
          {.size = size_to_fit(pane.label, width, 18), .font = Font::bold, .ground = paper});
    const std::string title = title_of(input);
    const bool two_lines = title.find('\n') != std::string::npos;
    write(renderer, title, {area.x + margin, top - (two_lines ? 36 : 50)},
          {.color = faint_ink, .size = size_to_fit(title, width, 13), .ground = paper});
}

} // namespace

DrawnPane draw_space(vtkRenderer& renderer, const Area& area, const SpaceInput& input) {
    const vtkSmartPointer<vtkPlane> clip = clipping_plane(input.state);
    draw_model(renderer, input, clip);
    const DrawnCells cells = draw_cells(renderer, input, clip);
    DrawnPane drawn = draw_path(renderer, input);
    drawn.cells = cells.boxes;
    drawn.split_planes = cells.planes;
    drawn.left_out = cells.left_out;
    draw_selected(renderer, input);
    draw_why(renderer, input);
    write_title(renderer, area, input);
    return drawn;
}

} // namespace raysteps::view
