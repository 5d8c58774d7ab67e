#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace raysteps {

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

} // namespace raysteps
