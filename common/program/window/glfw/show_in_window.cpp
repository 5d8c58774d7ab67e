#include "program/window/show_in_window.h"

#include "program/window/glfw/viewer.h"

namespace raysteps {

void show_in_window(WindowContext& context, const Camera& start,
                    const std::filesystem::path& screenshot, const RenderPicture& render) {
    Viewer(context.window(), start, screenshot, render).run();
}

} // namespace raysteps
