#include "scene/coarse_view.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raysteps {

namespace {

using EyeCorners = std::array<glm::dvec3, 3>; // right, up and forward of the eye

// Where a corner falls, in pixels from the lower left, and one over its depth.
glm::dvec3 projected(const CoarseView& view, const glm::dvec3& corner) {
    const double over_depth = 1.0 / corner.z;
    return {0.5 * view.width * (1.0 + corner.x * over_depth / view.right_slope),
            0.5 * view.height * (1.0 + corner.y * over_depth / view.up_slope), over_depth};
}

double edge_side(const glm::dvec3& a, const glm::dvec3& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

// Of the parts of a triangle: neighbours leave no gap between them.
constexpr double rounding = 1e-12;

// The pixels whose middle lies in the triangle of three projected corners.
void fill(CoarseView& view, int triangle, bool is_back, const EyeCorners& corners) {
    const auto& [a, b, c] = corners;
    const double area = edge_side(a, b, c.x, c.y);
    if (area == 0.0) {
        return;
    }
    const auto first = [](double least, int) {
        return static_cast<int>(std::ceil(std::max(least, 0.5) - 0.5));
    };
    const auto last = [](double greatest, int size) {
        return static_cast<int>(std::floor(std::min(greatest, size - 0.5) - 0.5));
    };
    for (int y = first(std::min({a.y, b.y, c.y}), view.height);
         y <= last(std::max({a.y, b.y, c.y}), view.height); ++y) {
        for (int x = first(std::min({a.x, b.x, c.x}), view.width);
             x <= last(std::max({a.x, b.x, c.x}), view.width); ++x) {
            const double of_a = edge_side(b, c, x + 0.5, y + 0.5) / area;
            const double of_b = edge_side(c, a, x + 0.5, y + 0.5) / area;
            const double of_c = 1.0 - of_a - of_b;
            if (std::min({of_a, of_b, of_c}) < -rounding) {
                continue;
            }
            const double depth = 1.0 / (of_a * a.z + of_b * b.z + of_c * c.z);
            const auto pixel = static_cast<std::size_t>(y * view.width + x);
            if (depth < view.depths[pixel]) {
                view.depths[pixel] = depth;
                view.triangles[pixel] = triangle;
                view.is_back[pixel] = is_back;
            }
        }
    }
}

bool is_beside(const CoarseView& view, const EyeCorners& corners) {
    const auto all = [&](const auto& is_out) {
        return std::all_of(corners.begin(), corners.end(), is_out);
    };
    return all([&](const glm::dvec3& p) { return p.x > view.right_slope * p.z; }) ||
           all([&](const glm::dvec3& p) { return -p.x > view.right_slope * p.z; }) ||
           all([&](const glm::dvec3& p) { return p.y > view.up_slope * p.z; }) ||
           all([&](const glm::dvec3& p) { return -p.y > view.up_slope * p.z; });
}

// The part of the triangle before the plane at the depth `near`, as one or two triangles
// (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974).
void fill_clipped(CoarseView& view, int triangle, bool is_back, const EyeCorners& corners,
                  double near) {
    std::array<glm::dvec3, 4> kept;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& from = corners[i];
        const glm::dvec3& to = corners[(i + 1) % 3];
        if (from.z >= near) {
            kept[count++] = from;
        }
        if ((from.z >= near) != (to.z >= near)) {
            const double part = (near - from.z) / (to.z - from.z);
            kept[count++] = from + part * (to - from);
        }
    }
    for (std::size_t i = 2; i < count; ++i) {
        fill(view, triangle, is_back,
             {projected(view, kept[0]), projected(view, kept[i - 1]), projected(view, kept[i])});
    }
}

} // namespace

CoarseView draw_coarsely(const Scene& scene, const glm::dvec3& eye, const ViewFrame& frame,
                         CoarseView view) {
    const auto pixels =
        static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    view.triangles.assign(pixels, -1);
    view.depths.assign(pixels, std::numeric_limits<double>::infinity());
    view.is_back.assign(pixels, false);
    for (int i = 0; i < triangle_count(scene); ++i) {
        EyeCorners corners;
        double nearest = std::numeric_limits<double>::infinity();
        double farthest = 0.0;
        for (std::size_t at = 0; at < 3; ++at) {
            const glm::dvec3 offset =
                glm::dvec3(scene.corners[3 * static_cast<std::size_t>(i) + at]) - eye;
            corners[at] = {glm::dot(offset, frame.right), glm::dot(offset, frame.up),
                           glm::dot(offset, frame.forward)};
            nearest = std::min(nearest, corners[at].z);
            farthest = std::max(farthest, corners[at].z);
        }
        if (farthest <= 0.0 || is_beside(view, corners)) {
            continue;
        }
        // In right, up and forward, which are left-handed, a front's normal points forward.
        const bool is_back = glm::dot(glm::cross(corners[1] - corners[0], corners[2] - corners[0]),
                                      corners[0]) < 0.0;
        fill_clipped(view, i, is_back, corners, std::max(nearest, 1e-6 * farthest));
    }
    return view;
}

namespace {

// Where the middle of a pixel lies on the plane at depth 1.
glm::dvec2 slopes_of(const CoarseView& view, std::size_t pixel) {
    const auto width = static_cast<std::size_t>(view.width);
    const double column = static_cast<double>(pixel % width) + 0.5;
    const double row = static_cast<double>(pixel / width) + 0.5;
    return {view.right_slope * (2.0 * column / view.width - 1.0),
            view.up_slope * (2.0 * row / view.height - 1.0)};
}

} // namespace

glm::dvec3 place_in(const CoarseView& view, std::size_t pixel) {
    return view.depths[pixel] * glm::dvec3(slopes_of(view, pixel), 1.0);
}

double solid_angle_of(const CoarseView& view, std::size_t pixel) {
    const glm::dvec2 slopes = slopes_of(view, pixel);
    const double area = 4.0 * view.right_slope * view.up_slope / (view.width * view.height);
    return area / std::pow(1.0 + glm::dot(slopes, slopes), 1.5);
}

} // namespace raysteps
