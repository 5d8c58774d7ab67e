#include "scene/append_model.h"

#include "catch.h"
#include "scene/shapes.h"
#include "scene_tests.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <rapidcheck.h>

#include <cmath>

using namespace raysteps;

namespace {

glm::mat4 scaling(const glm::vec3& factors) {
    glm::mat4 matrix{1.0f};
    for (int i = 0; i < 3; ++i) {
        matrix[i][i] = factors[i];
    }
    return matrix;
}

} // namespace

TEST_CASE("the identity changes no bit of a model", "[scene]") {
    const Scene model = add_mesh({}, sphere({1.0f, 2.0f, 3.0f}, 0.7f, 3), {});
    const Scene scene = append_model({}, model, glm::mat4(1.0f));
    REQUIRE(scene.corners == model.corners);
    REQUIRE(scene.triangle_materials == model.triangle_materials);
}

TEST_CASE("a second model stands behind the first with its own materials", "[scene]") {
    Material red;
    red.name = "red";
    Scene model = add_mesh({}, box(glm::vec3(0.0f), glm::vec3(1.0f)), red);
    model.models = {{"box.obj", glm::mat4(1.0f)}};
    model.messages = {"a box"};
    const Scene once = append_model({}, model, glm::mat4(1.0f));
    const Scene twice = append_model(once, model, scaling(glm::vec3(2.0f)));
    REQUIRE(triangle_count(twice) == 24);
    REQUIRE(twice.materials.size() == 2);
    REQUIRE(twice.triangle_materials.front() == 0);
    REQUIRE(twice.triangle_materials.back() == 1);
    REQUIRE(twice.models.size() == 2);
    REQUIRE(twice.messages.size() == 2);
    REQUIRE(twice.normals.size() == 72);
    REQUIRE(twice.texture_coordinates.size() == 72);
}

TEST_CASE("beside a model with texture coordinates one without has zeros", "[scene]") {
    const Scene plain = [] {
        Scene scene = add_mesh({}, triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {});
        scene.texture_coordinates.clear();
        return scene;
    }();
    Scene painted = plain;
    painted.texture_coordinates.assign(3, glm::vec2(0.5f));
    const glm::mat4 as_it_is(1.0f);
    CHECK(append_model(plain, plain, as_it_is).texture_coordinates.empty());
    const glm::vec2 zero(0.0f);
    const glm::vec2 half(0.5f);
    CHECK(append_model(plain, painted, as_it_is).texture_coordinates ==
          std::vector{zero, zero, zero, half, half, half});
    CHECK(append_model(painted, plain, as_it_is).texture_coordinates ==
          std::vector{half, half, half, zero, zero, zero});
}

TEST_CASE("a normal on a stretched slope stays upright on it", "[scene]") {
    // The slope x + y = 0 stretched to y = -x / 3: its normal (1, 1, 0) becomes (1, 3, 0), not (3,
    // 1, 0).
    const Scene model = add_mesh({}, quad({0, 0, 0}, {1, -1, 0}, {1, -1, -1}, {0, 0, -1}), {});
    const Scene scene = append_model({}, model, scaling({3.0f, 1.0f, 1.0f}));
    const glm::vec3 expected = glm::normalize(glm::vec3(1.0f, 3.0f, 0.0f));
    REQUIRE(glm::distance(scene.normals[0], expected) < 4.0f * 0x1p-24f); // one rounding each
}

TEST_CASE("a mirrored model keeps its fronts outside", "[scene]") {
    const Scene model = add_mesh({}, box({1.0f, 2.0f, 3.0f}, {2.0f, 4.0f, 6.0f}), {});
    const Scene scene = append_model({}, model, scaling({-1.0f, 1.0f, 1.0f}));
    REQUIRE(signed_volume(model.corners) == 6.0);
    REQUIRE(signed_volume(scene.corners) == 6.0);
    for (std::size_t i = 0; i < scene.corners.size(); i += 3) {
        const glm::vec3 front = glm::cross(scene.corners[i + 1] - scene.corners[i],
                                           scene.corners[i + 2] - scene.corners[i]);
        REQUIRE(glm::dot(front, scene.normals[i]) > 0.0f);
    }
}

TEST_CASE("every transform keeps a model closed and its normals on the front", "[scene]") {
    const Scene model = add_mesh({}, sphere(glm::vec3(0.5f), 1.0f, 2), {});
    REQUIRE(rc::check([&model] {
        glm::mat4 transform{1.0f};
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 3; ++row) {
                transform[column][row] = static_cast<float>(*rc::gen::inRange(-8, 9));
            }
        }
        const glm::dmat3 linear{glm::dmat4(transform)};
        const double volume = glm::determinant(linear); // of whole numbers, so exact
        RC_PRE(volume != 0.0);
        const Scene scene = append_model({}, model, transform);
        RC_ASSERT(count_open_edges(scene.corners) == 0);
        RC_ASSERT(signed_volume(scene.corners) > 0.0);
        for (std::size_t i = 0; i < scene.corners.size(); ++i) {
            // Three roundings of 2^-24 relative to a component.
            const double length = glm::length(glm::dvec3(scene.normals[i]));
            RC_ASSERT(std::abs(length - 1.0) < 3.0 * 0x1p-24);
        }
        // An inverse transpose keeps dot products: the image of a tangent stays across the normal.
        const glm::dvec3 tangent(0.0, 1.0, 0.0);
        const Scene upright = append_model(
            {}, add_mesh({}, quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}), {}), transform);
        // The normal's rounding, 3 * 2^-24, times the tangent's length.
        const glm::dvec3 image = linear * tangent;
        const double across = glm::dot(glm::dvec3(upright.normals[0]), image);
        RC_ASSERT(std::abs(across) < 3.0 * 0x1p-24 * glm::length(image));
    }));
}
