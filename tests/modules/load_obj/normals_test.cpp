#include "first_fault.h"
#include "model_folder.h"

#include "scene/mesh.h"
#include "scene/obj/load_obj.h"

#include "catch.h"

#include <glm/geometric.hpp>
#include <rapidcheck.h>

#include <array>
#include <cmath>

using namespace raysteps;

namespace {

// Both are unit vectors right to 2^-24 in each component (6e-8); 3e-7 is five times that.
void check_same_direction(const glm::vec3& a, const glm::vec3& b) {
    CHECK(glm::length(glm::dvec3(a) - glm::dvec3(b)) < 3e-7);
}

} // namespace

TEST_CASE("faces of one smoothing group share normals weighted by their angles", "[obj]") {
    const Scene scene = load_obj(corpus_file("smooth_roof.obj"));
    REQUIRE(triangle_count(scene) == 6);
    const glm::vec3 left = glm::normalize(glm::vec3(-1, 1, 0));
    const glm::vec3 ridge(0, 1, 0);
    check_same_direction(scene.normals[0], ridge);
    check_same_direction(scene.normals[1], left);
    CHECK(scene.corners[12].y == -1.0f); // the floor stands outside the group
    check_same_direction(scene.normals[12], glm::vec3(0, -1, 0));
    CHECK_THAT(joined(scene.messages),
               contains_text("Of its corners, 0 have normals of their own, 12 angle-weighted ones "
                             "within smoothing groups, and 6 flat ones."));
}

TEST_CASE("the corner of a cube gets the diagonal however its faces are cut", "[normals]") {
    // Three faces of a cube at the origin, of which one is cut into two triangles there. Weighted
    // by angle, the cut does not show; counted by triangles, that face would pull at the normal.
    const glm::vec3 o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), xy(1, 1, 0);
    const std::array<glm::vec3, 12> corners = {o, x, xy, o, xy, y, o, y, z, o, z, x};
    std::array<std::int64_t, 12> surfaces;
    surfaces.fill(7);
    for (std::size_t i = 0; i < 12; ++i)
        surfaces[i] = i % 3 == 0 ? 7 : flat;
    const std::vector<glm::vec3> normals = corner_normals(corners, surfaces);
    for (std::size_t i = 0; i < 12; i += 3)
        check_same_direction(normals[i], glm::normalize(glm::vec3(1, 1, 1)));
    check_same_direction(normals[1], glm::vec3(0, 0, 1));
}

TEST_CASE("a triangle without area has the normals of the triangles around it", "[normals]") {
    // Two squares at a right angle; between them a triangle on a line that is part of their edge.
    const glm::vec3 a(0, 0, 0), b(2, 0, 0), middle(1, 0, 0), up(0, 2, 0), out(0, 0, 2);
    const std::array<glm::vec3, 9> corners = {a, b, up, a, out, b, a, middle, b};
    std::array<std::int64_t, 9> surfaces;
    surfaces.fill(flat);
    const std::vector<glm::vec3> normals = corner_normals(corners, surfaces);
    for (const std::size_t at : {6, 8}) { // both meet it at equal angles there
        check_same_direction(normals[at], glm::normalize(glm::vec3(0, 1, 1)));
    }
    CHECK(has_unit_length(normals[7])); // nobody else has that corner
    CHECK(normals[7].x == 0.0f);        // across the line
}

TEST_CASE("where smooth normals cancel out each triangle keeps its own", "[obj]") {
    const Scene scene = load_obj(corpus_file("smooth_both_sides.obj"));
    CHECK(scene.normals[0] == glm::vec3(0, 0, 1));
    CHECK(scene.normals[3] == glm::vec3(0, 0, -1));
    CHECK_THAT(joined(scene.messages),
               contains_text("angle-weighted within its smoothing groups."));
}

TEST_CASE("normals that give no direction are made instead with a message", "[obj]") {
    const Scene scene = load_obj(corpus_file("nan_normal.obj"));
    for (const glm::vec3& normal : scene.normals)
        CHECK(normal == glm::vec3(0, 0, 1));
    CHECK_THAT(joined(scene.messages), contains_text("nan_normal.obj:4: A normal is zero or not "
                                                     "finite") &&
                                           contains_text("4 times (lines 4, 5, 6, 7)."));
}

TEST_CASE("a model that says nothing of normals is flat and says so", "[obj]") {
    const Scene scene = load_obj(corpus_file("no_line_end.obj"));
    CHECK(scene.normals[0] == glm::vec3(0, 0, 1));
    CHECK_THAT(joined(scene.messages), contains_text("so every triangle is flat."));
}

TEST_CASE("smooth normals have length 1 and do not depend on the order of corners", "[normals]") {
    REQUIRE(rc::check([] {
        const auto triangles = *rc::gen::inRange(1, 12);
        std::vector<glm::vec3> corners;
        std::vector<std::int64_t> surfaces;
        for (int i = 0; i < 3 * triangles; ++i) {
            const auto place = *rc::gen::inRange(0, 27); // a grid of 3 x 3 x 3 points
            corners.emplace_back(place % 3, place / 3 % 3, place / 9);
            surfaces.push_back(place);
        }
        const std::vector<glm::vec3> normals = corner_normals(corners, surfaces);
        for (const glm::vec3& normal : normals)
            RC_ASSERT(has_unit_length(normal));
        for (std::size_t i = 0; i < corners.size(); i += 3) // else any normal across will do
            RC_PRE(area_vector(corners[i], corners[i + 1], corners[i + 2]) != glm::dvec3(0));

        std::vector<glm::vec3> turned;
        std::vector<std::int64_t> turned_surfaces;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            turned.push_back(corners[i / 3 * 3 + (i + 1) % 3]);
            turned_surfaces.push_back(surfaces[i / 3 * 3 + (i + 1) % 3]);
        }
        const std::vector<glm::vec3> again = corner_normals(turned, turned_surfaces);
        for (std::size_t i = 0; i < corners.size(); ++i) // rounding differs, see least_agreement
            RC_ASSERT(glm::length(again[i] - normals[i / 3 * 3 + (i + 1) % 3]) < 1e-5f);
    }));
}
