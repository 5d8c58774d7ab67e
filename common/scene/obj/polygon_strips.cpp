#include "scene/polygon_strips.h"

#include <algorithm>
#include <numeric>

namespace raysteps {

PolygonStrips::PolygonStrips(std::span<const glm::dvec2> points)
    : points_(points),
      strip_size_(1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(points.size())))),
      order_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    const auto is_left = [this](int a, int b) { return points_[a].x < points_[b].x; };
    const auto is_below = [this](int a, int b) { return points_[a].y < points_[b].y; };
    std::sort(order_.begin(), order_.end(), is_left);
    for (std::size_t first = 0; first < order_.size(); first += strip_size_) {
        const std::size_t end = std::min(first + strip_size_, order_.size());
        left_.push_back(points_[order_[first]].x);
        right_.push_back(points_[order_[end - 1]].x);
        const auto begin = order_.begin();
        std::sort(begin + static_cast<Order::difference_type>(first),
                  begin + static_cast<Order::difference_type>(end), is_below);
    }
}

} // namespace raysteps
