#pragma once

#include "scene/scene.h"
#include "scene/view.h"

#include <cstddef>
#include <vector>

namespace raysteps {

// What one sees of a scene's triangles from a place, in few pixels: enough to choose a camera by.
// It is drawn and not traced, since no structure has been built when a camera is chosen.
struct CoarseView {
    int width = 0;
    int height = 0;
    double up_slope = 1.0;      // of the upper edge: its height over its distance
    double right_slope = 1.0;   // of the right edge
    std::vector<int> triangles; // of each pixel, from the lower left on; no_triangle for none
    std::vector<double> depths; // along the line of sight; infinite for none
    std::vector<bool>
        is_back{}; // of each pixel: seen from the side where the corners run clockwise
};

// The size and slopes of the view are given; what it shows is drawn from the eye.
CoarseView draw_coarsely(const Scene& scene, const glm::dvec3& eye, const ViewFrame& frame,
                         CoarseView view);

// What the middle of a pixel shows, as right, up and forward of the eye; infinite where it shows
// nothing.
glm::dvec3 place_in(const CoarseView& view, std::size_t pixel);

// The solid angle of a pixel, in steradians.
double solid_angle_of(const CoarseView& view, std::size_t pixel);

} // namespace raysteps
