#include "scene/obj/polygon.h"

#include "catch.h"

#include <rapidcheck.h>

#include <algorithm>

using namespace raysteps;

TEST_CASE("the points found in a box are those that comparing with all points finds", "[polygon]") {
    REQUIRE(rc::check([] {
        // Few different coordinates, so that many points are equal or lie on the box.
        const auto coordinate = [] { return static_cast<double>(*rc::gen::inRange(0, 9)); };
        std::vector<glm::dvec2> points(*rc::gen::inRange<std::size_t>(1, 80));
        for (glm::dvec2& point : points)
            point = {coordinate(), coordinate()};
        const glm::dvec2 lower(coordinate(), coordinate());
        const glm::dvec2 upper(coordinate(), coordinate());

        std::vector<int> found;
        const PolygonStrips strips(points);
        RC_ASSERT(!strips.any_in_box(lower, upper, [&](int point) {
            found.push_back(point);
            return false;
        }));
        std::sort(found.begin(), found.end());

        std::vector<int> expected;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (points[i].x >= lower.x && points[i].x <= upper.x && points[i].y >= lower.y &&
                points[i].y <= upper.y)
                expected.push_back(static_cast<int>(i));
        RC_ASSERT(found == expected);
    }));
}
