#include "parting.h"

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

bool same_tests(std::span<const TriangleTest> a, std::span<const TriangleTest> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const TriangleTest& first, const TriangleTest& second) {
                          return first.triangle == second.triangle;
                      });
}

// The last step, where the place is past the end.
std::size_t step_or_last(const RecordedWalk& walk, std::size_t step) {
    return walk.steps.empty() ? 0 : std::min(step, walk.steps.size() - 1);
}

std::size_t step_of_test(const RecordedWalk& walk, std::size_t test) {
    const auto place =
        std::upper_bound(walk.steps.begin(), walk.steps.end(), test,
                         [](std::size_t t, const Step& step) { return t < step.end_test; });
    return step_or_last(walk, static_cast<std::size_t>(place - walk.steps.begin()));
}

// Whether both have found the same so far. Another triangle test than ours may round otherwise, by
// much less than this part of t (scripts/course/exercises.py allows the same).
constexpr float same_t = 0x1p-16f;

bool same_nearest(const Hit& a, const Hit& b) {
    return a.triangle == b.triangle &&
           (a.triangle == no_triangle ||
            std::abs(a.t - b.t) <= same_t * std::max({1.0f, std::abs(a.t), std::abs(b.t)}));
}

std::optional<Parting> part_by_places(const RecordedWalk& a, const RecordedWalk& b) {
    const std::size_t both = std::min(a.steps.size(), b.steps.size());
    std::size_t i = 0;
    while (i < both && a.steps[i].cell == b.steps[i].cell &&
           a.steps[i].outcome == b.steps[i].outcome &&
           same_tests(tests_of(a, a.steps[i]), tests_of(b, b.steps[i])) &&
           same_nearest(a.steps[i].nearest, b.steps[i].nearest)) {
        ++i;
    }
    if (i == a.steps.size() && i == b.steps.size()) {
        return std::nullopt;
    }
    return Parting{step_or_last(a, i), step_or_last(b, i)};
}

std::optional<Parting> part_by_tests(const RecordedWalk& a, const RecordedWalk& b) {
    const auto place = std::mismatch(a.tests.begin(), a.tests.end(), b.tests.begin(), b.tests.end(),
                                     [](const TriangleTest& first, const TriangleTest& second) {
                                         return first.triangle == second.triangle;
                                     });
    if (place.first == a.tests.end() && place.second == b.tests.end()) {
        return std::nullopt;
    }
    const auto test = static_cast<std::size_t>(place.first - a.tests.begin());
    return Parting{step_of_test(a, test), step_of_test(b, test)};
}

} // namespace

std::optional<Parting> find_parting(const WalkIn& first, const WalkIn& second) {
    return same_cells(first.structure, second.structure) ? part_by_places(first.walk, second.walk)
                                                         : part_by_tests(first.walk, second.walk);
}

} // namespace raysteps
