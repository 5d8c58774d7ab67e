#include "scene/obj/polygon.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <queue>

namespace raysteps {

namespace {

// Twice the polygon's area, as a vector. Around the first corner, so that a polygon that is far
// from the origin loses nothing to rounding.
glm::dvec3 mean_normal(std::span<const glm::vec3> corners) {
    const glm::dvec3 origin = corners.front();
    glm::dvec3 sum{0.0};
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += glm::cross(glm::dvec3(corners[i - 1]) - origin, glm::dvec3(corners[i]) - origin);
    return sum;
}

// A polygon without crossings is done after a few tests a corner. One that needs more has crossings
// and no right answer, so it gets any answer.
constexpr std::size_t most_tests_per_corner = 32;

constexpr int cut_off = -1;

bool is_in_triangle(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b,
                    const glm::dvec2& c) {
    return turn(a, b, point) >= 0.0 && turn(b, c, point) >= 0.0 && turn(c, a, point) >= 0.0;
}

class EarCutter {
public:
    explicit EarCutter(std::span<const glm::dvec2> points);
    std::vector<std::array<int, 3>> cut_all();

private:
    bool is_ear(int corner);
    bool blocks(int corner, int ear) const;
    void cut(int corner);
    void wait_for_all();

    std::span<const glm::dvec2> points_;
    PolygonStrips strips_;
    std::vector<int> next_; // of each corner, the next one that is left, or cut_off
    std::vector<int> previous_;
    std::queue<int> waiting_; // corners that may be ears
    std::vector<std::array<int, 3>> triangles_;
    std::size_t left_;
    std::size_t tests_left_;
    int some_corner_ = 0; // one that is left
};

EarCutter::EarCutter(std::span<const glm::dvec2> points)
    : points_(points), strips_(points), next_(points.size()), previous_(points.size()),
      left_(points.size()), tests_left_(most_tests_per_corner * points.size()) {
    const int count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i) {
        next_[i] = (i + 1) % count;
        previous_[i] = (i + count - 1) % count;
    }
    wait_for_all();
}

std::vector<std::array<int, 3>> EarCutter::cut_all() {
    bool found_ears = false;
    while (left_ > 3) {
        if (waiting_.empty() && !found_ears)
            cut(some_corner_);
        if (waiting_.empty()) {
            wait_for_all();
            found_ears = false;
        }
        const int corner = waiting_.front();
        waiting_.pop();
        if (left_ > 3 && next_[corner] != cut_off && is_ear(corner)) {
            cut(corner);
            found_ears = true;
        }
    }
    cut(some_corner_);
    return std::move(triangles_);
}

bool EarCutter::is_ear(int corner) {
    if (tests_left_ == 0)
        return false;
    --tests_left_;
    const glm::dvec2& a = points_[previous_[corner]];
    const glm::dvec2& b = points_[corner];
    const glm::dvec2& c = points_[next_[corner]];
    if (turn(a, b, c) <= 0.0)
        return false;
    return !strips_.any_in_box(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)),
                               [&](int other) { return blocks(other, corner); });
}

// Only a corner that is not convex can block: if any corner lies in the triangle, one such does.
// Corners at the same place as the ear's are where a polygon touches itself, as around a hole.
bool EarCutter::blocks(int corner, int ear) const {
    if (next_[corner] == cut_off)
        return false;
    const glm::dvec2& point = points_[corner];
    const glm::dvec2& a = points_[previous_[ear]];
    const glm::dvec2& b = points_[ear];
    const glm::dvec2& c = points_[next_[ear]];
    if (point == a || point == b || point == c || !is_in_triangle(point, a, b, c))
        return false;
    return turn(points_[previous_[corner]], point, points_[next_[corner]]) <= 0.0;
}

void EarCutter::cut(int corner) {
    const int before = previous_[corner];
    const int after = next_[corner];
    triangles_.push_back({before, corner, after});
    next_[before] = after;
    previous_[after] = before;
    next_[corner] = cut_off;
    waiting_.push(before);
    waiting_.push(after);
    some_corner_ = after;
    --left_;
}

void EarCutter::wait_for_all() {
    int corner = some_corner_;
    for (std::size_t i = 0; i < left_; ++i) {
        waiting_.push(corner);
        corner = next_[corner];
    }
}

// The corners that do not stand where the one before them stands.
std::vector<int> different_corners(std::span<const glm::vec3> corners) {
    std::vector<int> different;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (different.empty() || corners[i] != corners[different.back()])
            different.push_back(static_cast<int>(i));
    while (different.size() > 1 && corners[different.front()] == corners[different.back()])
        different.pop_back();
    return different;
}

std::vector<PolygonTriangle> cut_fan(std::size_t corner_count) {
    std::vector<PolygonTriangle> triangles;
    triangles.reserve(corner_count - 2);
    for (int i = 2; i < static_cast<int>(corner_count); ++i)
        triangles.push_back({0, i - 1, i});
    return triangles;
}

bool fan_covers(std::span<const glm::dvec2> points) {
    for (std::size_t i = 2; i < points.size(); ++i)
        if (!(turn(points[0], points[i - 1], points[i]) > 0.0))
            return false;
    return true;
}

std::vector<PolygonTriangle> cut_polygon(std::span<const glm::vec3> corners) {
    if (corners.size() == 3)
        return cut_fan(3);
    const std::vector<glm::dvec2> points = flatten_polygon(corners);
    return fan_covers(points) ? cut_fan(points.size()) : cut_ears(points);
}

} // namespace

std::vector<glm::dvec2> flatten_polygon(std::span<const glm::vec3> corners) {
    const glm::dvec3 normal = mean_normal(corners);
    const glm::dvec3 size = glm::abs(normal);
    int axis = size.x > size.y ? 0 : 1;
    axis = size[axis] > size.z ? axis : 2;
    const int other = normal[axis] < 0.0 ? 2 : 1;
    const int right = (axis + other) % 3;
    const int up = (axis + 3 - other) % 3;

    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    for (const glm::vec3& corner : corners)
        flat.emplace_back(corner[right], corner[up]);
    return flat;
}

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

std::vector<std::array<int, 3>> cut_ears(std::span<const glm::dvec2> points) {
    return EarCutter(points).cut_all();
}

std::vector<PolygonTriangle> triangulate_polygon(std::span<const glm::vec3> corners) {
    if (corners.size() == 3 && corners[0] != corners[1] && corners[1] != corners[2] &&
        corners[2] != corners[0])
        return cut_fan(3); // as below, but most polygons of large models are such
    const std::vector<int> different = different_corners(corners);
    if (different.size() < 3)
        return {};
    std::vector<glm::vec3> polygon;
    polygon.reserve(different.size());
    for (const int corner : different)
        polygon.push_back(corners[corner]);

    // A triangle with two equal corners has one edge, there and back: it closes nothing. One whose
    // corners lie on a line may close a slit between neighbours that name more or fewer of them.
    std::vector<PolygonTriangle> triangles;
    for (const auto& [a, b, c] : cut_polygon(polygon))
        if (polygon[a] != polygon[b] && polygon[b] != polygon[c] && polygon[c] != polygon[a])
            triangles.push_back({different[a], different[b], different[c]});
    return triangles;
}

} // namespace raysteps
