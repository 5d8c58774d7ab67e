#include "drawing.h"

#include "draw.h"
#include "paint.h"
#include "visualizer/framing.h"
#include "visualizer/keys.h"

#include <glm/geometric.hpp>
#include <vtkCamera.h>

#include <algorithm>

namespace raysteps::view {

namespace {

void set_background(vtkRenderer& renderer, const glm::vec3& color) {
    renderer.SetBackground(static_cast<double>(color.x), static_cast<double>(color.y),
                           static_cast<double>(color.z));
}

vtkSmartPointer<vtkRenderer> add_renderer(vtkRenderWindow& window, const glm::vec3& background) {
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    set_background(*renderer, background);
    renderer->InteractiveOff();
    window.AddRenderer(renderer);
    return renderer;
}

// Transparent things are drawn in any order: depth peeling blends them from back to front.
void peel_depths(vtkRenderer& renderer) {
    renderer.SetUseDepthPeeling(1);
    renderer.SetMaximumNumberOfPeels(6);
    renderer.SetOcclusionRatio(0.0);
    renderer.SetUseFXAA(true);
}

void resize(std::vector<vtkSmartPointer<vtkRenderer>>& renderers, std::size_t count,
            vtkRenderWindow& window, const glm::vec3& background) {
    while (renderers.size() > count) {
        window.RemoveRenderer(renderers.back());
        renderers.pop_back();
    }
    while (renderers.size() < count) {
        renderers.push_back(add_renderer(window, background));
    }
}

// Of a large model, only as many as the mouse can turn smoothly, spread over all of it.
std::vector<glm::vec3> some_triangles(const std::vector<glm::vec3>& corners) {
    constexpr std::size_t most = 250000;
    const std::size_t count = corners.size() / 3;
    const std::size_t stride = (count + most - 1) / most;
    if (stride <= 1) {
        return corners;
    }
    std::vector<glm::vec3> some;
    for (std::size_t i = 0; i < count; i += stride) {
        some.insert(some.end(), {corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]});
    }
    return some;
}

glm::vec3 to_glm(const double* point) {
    return {static_cast<float>(point[0]), static_cast<float>(point[1]),
            static_cast<float>(point[2])};
}

// The size of letters with which a sheet is as high as that, or lower.
int sheet_size(const std::string& text, int height) {
    constexpr int usual = 14;
    constexpr double line_of_size = 1.17; // the height of a line over the size of its letters
    const auto lines = static_cast<double>(std::count(text.begin(), text.end(), '\n') + 1);
    return std::clamp(static_cast<int>(height / (line_of_size * lines)), 6, usual);
}

} // namespace

Drawing::Drawing(vtkRenderWindow& window) : window_(window) {
    window_.SetAlphaBitPlanes(1);
    window_.SetMultiSamples(0);
    side_ = add_renderer(window_, panel);
    bottom_ = add_renderer(window_, panel);
    sheet_ = add_renderer(window_, panel);
    sheet_->SetLayer(1);
    window_.SetNumberOfLayers(2);
}

void Drawing::arrange(const Stage& stage, const State& state) {
    layout_ = layout_of(state, stage.panes().size());
    window_.SetSize(state.window.x, state.window.y);
    resize(spaces_, layout_.panes.size(), window_, paper);
    resize(heat_maps_, layout_.heat_maps.size(), window_, paper);
    for (std::size_t i = 0; i < spaces_.size(); ++i) {
        place_renderer(*spaces_[i], layout_.panes[i], state.window);
        spaces_[i]->InteractiveOn();
        spaces_[i]->SetActiveCamera(spaces_.front()->GetActiveCamera());
        peel_depths(*spaces_[i]);
    }
    for (std::size_t i = 0; i < heat_maps_.size(); ++i) {
        place_renderer(*heat_maps_[i], layout_.heat_maps[i], state.window);
    }
    place_renderer(*side_, layout_.side, state.window);
    place_renderer(*bottom_, layout_.bottom, state.window);
    place_renderer(*sheet_, {0, 0, state.window.x, state.window.y}, state.window);
    for (const auto& renderers : {spaces_, heat_maps_, {side_, bottom_, sheet_}}) {
        for (const vtkSmartPointer<vtkRenderer>& renderer : renderers) {
            renderer->RemoveAllViewProps();
        }
    }
}

Camera Drawing::camera_of(const Stage& stage, const State& state) const {
    const Area& area = layout_.panes.front();
    const double aspect = static_cast<double>(area.width) / area.height;
    return state.viewpoint ? *state.viewpoint : frame_stage(stage, aspect);
}

void Drawing::aim(const Camera& from) {
    vtkCamera& camera = *spaces_.front()->GetActiveCamera();
    camera.SetPosition(from.eye.x, from.eye.y, from.eye.z);
    camera.SetFocalPoint(from.target.x, from.target.y, from.target.z);
    camera.SetViewUp(from.up.x, from.up.y, from.up.z);
    camera.SetViewAngle(static_cast<double>(from.vertical_field_of_view));
    for (const vtkSmartPointer<vtkRenderer>& space : spaces_) {
        space->ResetCameraClippingRange();
    }
}

Camera Drawing::viewpoint() const {
    vtkCamera& camera = *spaces_.front()->GetActiveCamera();
    return {to_glm(camera.GetPosition()), to_glm(camera.GetFocalPoint()),
            to_glm(camera.GetViewUp()), static_cast<float>(camera.GetViewAngle())};
}

std::vector<DrawnPane> Drawing::draw(const Stage& stage, const State& state) {
    arrange(stage, state);
    if (model_of_ != stage.scene().corners.data() || !model_) {
        model_ = triangles(some_triangles(stage.scene().corners));
        model_of_ = stage.scene().corners.data();
    }
    const Camera from = camera_of(stage, state);
    const double distance = glm::distance(glm::dvec3(from.eye), glm::dvec3(from.target));
    std::vector<DrawnPane> drawn;
    for (std::size_t i = 0; i < spaces_.size(); ++i) {
        drawn.push_back(draw_space(*spaces_[i], layout_.panes[i],
                                   {stage, state, i, model_, from.eye, distance}));
    }
    aim(from);
    for (std::size_t i = 0; i < heat_maps_.size(); ++i) {
        draw_heat_map(*heat_maps_[i], layout_.heat_maps[i], stage, state, i);
    }
    draw_side(*side_, layout_, stage, state, drawn);
    draw_bottom(*bottom_, layout_, stage, state);
    if (state.help) {
        const std::string text = help_text(state);
        write(*sheet_, text, {60, state.window.y - 60},
              {.size = sheet_size(text, state.window.y - 80), .font = Font::code, .boxed = true});
    }
    return drawn;
}

} // namespace raysteps::view
