#pragma once

#include "gpu/gl.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "image/image.h"
#include "program/show.h"
#include "scene/scene.h"

#include <filesystem>

namespace raysteps {

// How coarse a picture is: one of its pixels stands for a square of the window with so many pixels
// on a side. A power of two, and 1 is the full picture.

// Before any frame has been timed.
inline constexpr int first_coarseness = 8;

// The finest that a frame can have which takes a tenth of a second at most, after one that took
// so many seconds: half the coarseness has four times the pixels. At most 16.
int affordable_coarseness(int coarseness, double seconds);

// While the camera moves, frames are as coarse as it takes to keep up with it. `shown` is 0 where
// the window does not show yet what it should; once it rests the picture gets finer frame by frame.
int next_coarseness(int shown, int affordable);

// How long to wait for events before that frame, in seconds: not at all, or as long as the camera
// may still go on, or without end.
double wait_before_frame(int shown, double seconds_at_rest);

// The pixels of a picture along a side of the window.
int coarse_side(int side, int coarseness);

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

// A picture as a texture for the screen: components clamped to [0, 1], and NaN in the color that
// it has in PNG files too.
Texture screen_texture(const Image& image);

// Draws pictures to the window. Owns OpenGL objects.
class Screen {
public:
    Screen();
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    // Magnified to fill a window of so many pixels, and encoded in sRGB.
    void draw(const Texture& picture, int width, int height);

private:
    Program program_;
    GLuint vertices_ = 0; // core OpenGL draws nothing without one, even where no vertex has data
};

// NAME-1.png, or NAME-2.png where that is there already, and so on: the first that is free.
std::filesystem::path screenshot_path(const std::filesystem::path& name);

} // namespace raysteps
