#pragma once

#include "gpu/gl.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "image/image.h"

namespace raysteps {

// A picture as a texture for the screen: components clamped to [0, 1], and NaN in the color that
// it has in PNG files too.
Texture screen_texture(const Image& image);

// A rectangle of the window's pixels; left and bottom are those of its lower left corner.
struct ScreenPlace {
    int left = 0;
    int bottom = 0;
    int width = 0;
    int height = 0;
};

// Where a picture lies near the window's upper left corner: so many times its size, or smaller
// where the window is too small for it. The window has at least one pixel.
ScreenPlace overlay_place(const Image& overlay, double scale, int window_width, int window_height);

// Draws pictures to the window. Owns OpenGL objects.
class Screen {
public:
    Screen();
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    // Magnified to fill the place, and encoded in sRGB. The opacity is 1 where nothing shines
    // through.
    void draw(const Texture& picture, const ScreenPlace& place, float opacity);

private:
    Program program_;
    GLuint vertices_ = 0; // core OpenGL draws nothing without one, even where no vertex has data
};

} // namespace raysteps
