#include "visualizer/show_view.h"

#include "display.h"
#include "drawing.h"
#include "export.h"
#include "headless_window.h"
#include "screenshot.h"
#include "show_in_window.h"

#include <cstdio>
#include <iostream>

namespace raysteps::view {

namespace {

void say_written(const std::filesystem::path& path) {
    std::cout << "wrote     " << path.string() << "\n" << std::flush;
}

// A picture of each step: step_0001.png and so on.
void animate(Drawing& drawing, vtkRenderWindow& window, const Request& request,
             const Stage& stage) {
    State state = request.state;
    const int steps = step_count(stage, state);
    for (state.step = 0; state.step < steps; ++state.step) {
        drawing.draw(stage, state);
        char name[32];
        std::snprintf(name, sizeof name, "step_%04d.png", state.step + 1);
        write_screenshot(window, request.animation / name);
    }
    std::cout << "wrote     " << steps << " pictures to " << request.animation.string() << "\n";
}

void draw_without_display(const Request& request, const Stage& stage) {
    const auto window = make_headless_window(request.state.window);
    Drawing drawing(*window);
    drawing.draw(stage, request.state);
    const bool only_other_files =
        request.screenshot.empty() && (!request.exports.empty() || !request.animation.empty());
    if (!only_other_files) {
        const std::filesystem::path path =
            request.screenshot.empty() ? picture_path(request.state) : request.screenshot;
        write_screenshot(*window, path);
        say_written(path);
    }
    for (const std::filesystem::path& path : request.exports) {
        window->Render();
        export_drawing(path, stage, request.state, drawing, *window);
        say_written(path);
    }
    if (!request.animation.empty()) {
        animate(drawing, *window, request, stage);
    }
}

} // namespace

void show_view(const Request& request, Stage& stage) {
    const bool wants_files =
        !request.screenshot.empty() || !request.exports.empty() || !request.animation.empty();
    if (!wants_files && has_display()) {
        show_in_window(request, stage);
        return;
    }
    if (!wants_files) {
        std::cerr << "visualizer: there is no display, so a picture is written instead of a "
                     "window. --screenshot names its file.\n";
    }
    draw_without_display(request, stage);
}

} // namespace raysteps::view
