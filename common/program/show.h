#pragma once

#include "image/image.h"
#include "program/options.h"

#include <functional>
#include <string>
#include <vector>

namespace raysteps {

// Renders the picture that a camera sees, so many pixels wide and high.
using RenderPicture = std::function<Image(const Camera& camera, int width, int height)>;

// What a person may change while a window shows the picture: a word of a few.
struct LiveChoice {
    std::string name{};
    char key = ' '; // takes the next word; with shift, the one before
    std::vector<std::string> words{};
    std::size_t chosen = 0;
    // From now on the picture is rendered with that word. Throws Error where it cannot be; then all
    // is as before.
    std::function<void(const std::string& word)> take{};
};

// A pixel of a picture that a camera sees; 0,0 is at the top left.
struct SeenPixel {
    Camera camera;
    int width = 0;
    int height = 0;
    int column = 0;
    int row = 0;
};

// What a window offers beside the camera.
struct LiveOffer {
    std::vector<LiveChoice> choices{};
    std::function<void()> read_shaders{}; // anew; throws Error with the line that is wrong
    std::function<std::string(const SeenPixel&)> view_command{}; // that shows the ray of a pixel
    std::function<std::vector<std::string>()> notes{};           // on the last picture, in lines
};

// With --window: shows the picture in the window, rendering it anew as the camera moves, until the
// window is closed. Else renders it once, and writes NAME.png (sRGB) and NAME.pfm (linear floats)
// to the folder of --out.
void show_or_write(const PictureOptions& picture, Context& context, const Camera& camera,
                   const std::string& name, const RenderPicture& render, LiveOffer offer = {});

// Shows the picture in the window until it is closed, rendered anew as the camera moves: coarse
// while it does, in full when it rests. The mouse turns, moves and zooms like VTK's trackball
// (window/trackball.h), and H shows the keys. S writes the picture, in the window's full size, to
// SCREENSHOT-1.png or the next number that is free, and prints the path; C prints the camera. What
// is offered stands in a panel, beside its keys. Throws MachineError where the window cannot be
// drawn to, and what the renderer throws; where shaders can be read anew, the window says that
// instead, and keeps the last picture.
void show_in_window(WindowContext& context, const Camera& start,
                    const std::filesystem::path& screenshot, const RenderPicture& render,
                    LiveOffer offer = {});

} // namespace raysteps
