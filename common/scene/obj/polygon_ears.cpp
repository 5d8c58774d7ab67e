#include "scene/polygon_ears.h"

#include "scene/polygon_plane.h"
#include "scene/polygon_strips.h"

#include <glm/common.hpp>

#include <queue>

namespace raysteps {

namespace {

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

} // namespace

std::vector<std::array<int, 3>> cut_ears(std::span<const glm::dvec2> points) {
    return EarCutter(points).cut_all();
}

} // namespace raysteps
