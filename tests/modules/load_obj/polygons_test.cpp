#include "model_folder.h"

#include "scene/mesh.h"
#include "scene/obj/load_obj.h"
#include "scene/obj/polygon.h"

#include "catch.h"

#include <glm/geometric.hpp>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>

using namespace raysteps;

namespace {

using Polygon = std::vector<glm::vec3>;

glm::dvec3 area_of(const Polygon& polygon) {
    glm::dvec3 area{0.0};
    for (std::size_t i = 2; i < polygon.size(); ++i)
        area += area_vector(polygon[0], polygon[i - 1], polygon[i]);
    return area;
}

struct Cover {
    double sum = 0.0;      // of the areas, along the polygon's normal
    double absolute = 0.0; // of their sizes
    double least = 0.0;    // negative where a triangle is turned over, and so lies outside
};

// The areas of the triangles in units of the polygon's own. Triangles that turn as the polygon does
// and whose areas add up to its area leave no room for one that lies outside or overlaps another.
Cover cover_of(const Polygon& polygon) {
    const glm::dvec3 whole = area_of(polygon);
    Cover cover{0.0, 0.0, 1.0};
    for (const auto& [a, b, c] : triangulate_polygon(polygon)) {
        const double part = glm::dot(area_vector(polygon[a], polygon[b], polygon[c]), whole) /
                            glm::dot(whole, whole);
        cover.sum += part;
        cover.absolute += std::abs(part);
        cover.least = std::min(cover.least, part);
    }
    return cover;
}

// The corners are floats, the areas exact to 2^-50 or so each; n of them err by n * 1e-15 at most.
void check_covers(const Polygon& polygon, std::size_t triangles) {
    const double tolerance = 1e-14 * static_cast<double>(polygon.size());
    CHECK(triangulate_polygon(polygon).size() == triangles);
    const Cover cover = cover_of(polygon);
    CHECK(std::abs(cover.sum - 1.0) < tolerance);
    CHECK(cover.least >= 0.0);
}

// A spike and a notch in turn, around the origin: half of the corners are concave.
Polygon star(int corners, float inner_radius) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const double radius = i % 2 == 0 ? 1.0 : inner_radius;
        polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    return polygon;
}

// Teeth of no width between long gaps: ears are long and thin.
Polygon comb(int teeth) {
    Polygon polygon;
    for (int i = 0; i < teeth; ++i) {
        polygon.emplace_back(i, 0, 0);
        polygon.emplace_back(static_cast<float>(i) + 0.5f, 1000, 0);
    }
    polygon.emplace_back(teeth, 0, 0);
    polygon.emplace_back(teeth, -1, 0);
    polygon.emplace_back(0, -1, 0);
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

// A corridor that winds inwards: half as wide as its turns are apart, so that it never crosses.
Polygon spiral(int corners) {
    Polygon outside;
    Polygon inside;
    for (int i = 0; i < corners / 2; ++i) {
        const double angle = 0.1 * i;
        const double radius = 1.0 + angle / (2.0 * std::numbers::pi);
        outside.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
        inside.emplace_back((radius - 0.5) * std::cos(angle), (radius - 0.5) * std::sin(angle),
                            0.0);
    }
    outside.insert(outside.end(), inside.rbegin(), inside.rend());
    return outside;
}

// The five polygons of 20,000 corners below were measured at 0.6 s together in optimised code, and
// at 4 s in that of the preset `fuzz`, whose checks slow it down. This is the limit for each of
// them.
constexpr double most_seconds = 3.0;

// Of this program's own time, so that others on the machine do not count.
double seconds_for(const Polygon& polygon) {
    const std::clock_t start = std::clock();
    triangulate_polygon(polygon);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

} // namespace

TEST_CASE("a convex polygon becomes a fan around its first corner", "[polygon]") {
    const Polygon square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    CHECK(triangulate_polygon(square) == std::vector<PolygonTriangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("a concave quad is cut along the diagonal inside it from any first corner", "[polygon]") {
    const Scene scene = load_obj(corpus_file("concave_quad.obj"));
    REQUIRE(triangle_count(scene) == 8);
    for (std::size_t i = 0; i < scene.corners.size(); i += 3) {
        const glm::dvec3 area =
            area_vector(scene.corners[i], scene.corners[i + 1], scene.corners[i + 2]);
        CHECK(area == glm::dvec3(0, 0, 1)); // half of the quad's; the other diagonal gives -2 and 4
    }
}

TEST_CASE("a polygon of 256 corners becomes 254 triangles", "[polygon]") {
    const Scene scene = load_obj(corpus_file("polygon_of_256.obj"));
    CHECK(triangle_count(scene) == 254);
    check_covers(star(256, 1.0f), 254);
}

TEST_CASE("a polygon around a hole with a cut to it leaves the hole open", "[polygon]") {
    const Scene scene = load_obj(corpus_file("keyhole.obj"));
    CHECK(triangle_count(scene) == 8);
    double area = 0.0;
    for (std::size_t i = 0; i < scene.corners.size(); i += 3)
        area += area_vector(scene.corners[i], scene.corners[i + 1], scene.corners[i + 2]).z / 2;
    CHECK(area == 8.0); // 3 x 3 less the hole of 1 x 1
}

TEST_CASE("corners on a straight edge stay corners so that neighbours meet them", "[polygon]") {
    const Polygon polygon = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}};
    check_covers(polygon, 4);
}

TEST_CASE("a corner that stands where the one before it stands changes nothing", "[polygon]") {
    const Polygon once = star(20, 0.5f);
    Polygon twice;
    for (const glm::vec3& corner : once)
        twice.insert(twice.end(), 2, corner);
    std::vector<PolygonTriangle> expected = triangulate_polygon(once);
    for (PolygonTriangle& triangle : expected)
        for (int& corner : triangle)
            corner *= 2;
    CHECK(triangulate_polygon(twice) == expected);
}

TEST_CASE("polygons that cross themselves or have no area still end", "[polygon]") {
    CHECK(triangle_count(load_obj(corpus_file("pentagram.obj"))) <= 3);
    CHECK(triangle_count(load_obj(corpus_file("bow_tie.obj"))) <= 2);
    CHECK(triangulate_polygon(Polygon(9, {1, 2, 3})).empty());
    CHECK(triangulate_polygon(Polygon{}).empty());
    CHECK(triangulate_polygon(Polygon{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).size() == 2);
}

TEST_CASE("a triangle without area is kept unless two of its corners are one", "[polygon]") {
    CHECK(triangulate_polygon(Polygon{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}) ==
          std::vector<PolygonTriangle>{{0, 1, 2}});
    CHECK(triangulate_polygon(Polygon{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}).empty());
    CHECK(triangulate_polygon(Polygon{{0, 0, 0}, {1, 0, 0}, {-0.0f, 0, 0}}).empty());
}

TEST_CASE("stars and combs and spirals are covered once", "[polygon]") {
    check_covers(star(1000, 0.3f), 998);
    check_covers(star(1000, 0.999f), 998);
    check_covers(comb(300), 601);
    check_covers(spiral(1000), 998);
}

TEST_CASE("a polygon of 20000 corners is cut in a moment", "[polygon]") {
    CHECK(seconds_for(star(20000, 1.0f)) < most_seconds);
    CHECK(seconds_for(star(20000, 0.5f)) < most_seconds);
    CHECK(seconds_for(star(20000, 0.99999f)) < most_seconds);
    CHECK(seconds_for(comb(10000)) < most_seconds);
    CHECK(seconds_for(spiral(20000)) < most_seconds);
}

TEST_CASE("a polygon of 20000 corners at random places ends in a few seconds", "[polygon]") {
    const auto seed = GENERATE(1u, 2u);
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
    Polygon polygon;
    for (int i = 0; i < 20000; ++i)
        polygon.emplace_back(coordinate(random), coordinate(random), 0.0f);
    CHECK(seconds_for(polygon) < 5.0 * most_seconds);
}

TEST_CASE("a polygon around a point is covered once in any plane", "[polygon]") {
    REQUIRE(rc::check([] {
        const auto corners = *rc::gen::inRange(3, 60);
        const glm::vec3 right(*rc::gen::inRange(-4, 5), *rc::gen::inRange(-4, 5), 3);
        const glm::vec3 up(*rc::gen::inRange(-4, 5), 4, *rc::gen::inRange(-4, 5));
        RC_PRE(glm::length(glm::cross(right, up)) > 1.0f);
        Polygon polygon;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            const double radius = *rc::gen::inRange(1, 100);
            polygon.push_back(static_cast<float>(radius * std::cos(angle)) * right +
                              static_cast<float>(radius * std::sin(angle)) * up);
        }
        // Rounding lifts corners out of the plane by 1e-7 of the size, so the areas are right to
        // about that, times the number of triangles and how much larger the star is than a
        // triangle.
        const Cover cover = cover_of(polygon);
        RC_ASSERT(std::abs(cover.sum - 1.0) < 1e-4);
        RC_ASSERT(cover.absolute < 1.0 + 1e-4);
    }));
}
