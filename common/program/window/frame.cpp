#include "program/window/frame.h"

#include "program/window/coarseness.h"

#include <chrono>

namespace raysteps {

namespace {

bool same_camera(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up &&
           a.vertical_field_of_view == b.vertical_field_of_view;
}

} // namespace

bool same_sight(const Sight& a, const Sight& b) {
    return a.width == b.width && a.height == b.height && same_camera(a.camera, b.camera);
}

Frame render_frame(const RenderPicture& render, const Sight& sight, int coarseness) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    Frame frame;
    frame.sight = sight;
    frame.coarseness = coarseness;
    frame.image = render(sight.camera, coarse_side(sight.width, coarseness),
                         coarse_side(sight.height, coarseness));
    frame.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return frame;
}

} // namespace raysteps
