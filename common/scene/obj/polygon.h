#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace raysteps {

// The polygon seen along the axis that its mean normal is nearest to (Newell's method: Sutherland,
// Sproull and Schumacker, "A Characterization of Ten Hidden-Surface Algorithms", 1974), from the
// side where it runs counter-clockwise. Seen so, triangles keep their order of corners and their
// overlaps.
std::vector<glm::dvec2> flatten_polygon(std::span<const glm::vec3> corners);

// Twice the signed area of the triangle: positive where it turns counter-clockwise.
inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The points of a polygon, sorted so that a box need not be compared with all of them: by x into
// about sqrt(n) strips of equally many points, and by y within a strip. However the points cluster,
// a box meets at most sqrt(n) strips.
class PolygonStrips {
public:
    explicit PolygonStrips(std::span<const glm::dvec2> points);

    // Is the predicate true of one of the points (given by their numbers) in the closed box?
    template <class Predicate>
    bool any_in_box(const glm::dvec2& lower, const glm::dvec2& upper,
                    const Predicate& predicate) const;

private:
    using Order = std::vector<int>;

    std::span<const glm::dvec2> points_;
    std::size_t strip_size_;
    Order order_;
    std::vector<double> left_;  // of each strip, its smallest x
    std::vector<double> right_; // of each strip, its greatest x
};

template <class Predicate>
bool PolygonStrips::any_in_box(const glm::dvec2& lower, const glm::dvec2& upper,
                               const Predicate& predicate) const {
    const auto below = [this](int point, double y) { return points_[point].y < y; };
    const auto first_strip = std::lower_bound(right_.begin(), right_.end(), lower.x);
    auto strip = static_cast<std::size_t>(first_strip - right_.begin());
    for (; strip < left_.size() && left_[strip] <= upper.x; ++strip) {
        const auto begin =
            order_.begin() + static_cast<Order::difference_type>(strip * strip_size_);
        const auto end =
            begin + std::min<Order::difference_type>(
                        static_cast<Order::difference_type>(strip_size_), order_.end() - begin);
        auto point = std::lower_bound(begin, end, lower.y, below);
        for (; point != end && points_[*point].y <= upper.y; ++point)
            if (points_[*point].x >= lower.x && points_[*point].x <= upper.x && predicate(*point))
                return true;
    }
    return false;
}

// Cuts a counter-clockwise polygon of at least three points into n - 2 triangles by cutting off
// ears (Meisters, "Polygons have ears", American Mathematical Monthly, 1975): corners whose
// triangle holds no other corner. Where edges cross there may be none; then any corner is cut off,
// so that it ends.
std::vector<std::array<int, 3>> cut_ears(std::span<const glm::dvec2> points);

// Corners of a polygon, by their index in it.
using PolygonTriangle = std::array<int, 3>;

// Cuts a polygon of n corners in space into at most n - 2 triangles of three different corners,
// which turn as it does. A fan around corner 0 where that covers the polygon, as it does where it
// is convex; else ears are cut off (Meisters, "Polygons have ears", 1975), seen along the polygon's
// mean normal. Corners may lie on one line: such a triangle has no area, but each edge of the
// polygon is one of its triangles' all the same, so that a closed mesh stays closed.
// Where the edges cross, no answer is right: the triangles are then what cutting ears leaves.
// Time is about n^1.5 in polygons without crossings, and limited to a multiple of it in all.
std::vector<PolygonTriangle> triangulate_polygon(std::span<const glm::vec3> corners);

} // namespace raysteps
