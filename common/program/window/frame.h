#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "program/window/show_in_window.h"

namespace raysteps {

// What a window is to show: what the camera sees, in so many of the screen's pixels.
struct Sight {
    Camera camera;
    int width = 0;
    int height = 0;
};

// A minimised window has no pixels.
inline bool is_empty(const Sight& sight) {
    return sight.width < 1 || sight.height < 1;
}

bool same_sight(const Sight& a, const Sight& b);

// A picture of it, full or coarse.
struct Frame {
    Sight sight;
    int coarseness = 0; // 0: there is no picture yet
    Image image;
    double seconds = 0.0; // that it took
};

// Throws what the renderer throws.
Frame render_frame(const RenderPicture& render, const Sight& sight, int coarseness);

} // namespace raysteps
