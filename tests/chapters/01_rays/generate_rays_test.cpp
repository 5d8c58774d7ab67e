#include "basics/random_numbers.h"
#include "catch.h"
#include "gpu/context.h"
#include "mirror/mirror_scene.h"
#include "mirror/walks.h"
#include "reference/reference_ray.h"
#include "render/rays.h"
#include "render/show_hits.h"
#include "scene/load_scene.h"
#include "scene/view.h"
#include "support/expected_picture.h"
#include "support/same_bits.h"

#include <algorithm>
#include <glm/geometric.hpp>

using namespace raysteps;

namespace {

Camera camera_along_minus_z() {
    Camera camera;
    camera.eye = {0.0f, 0.0f, 1.0f};
    camera.target = {0.0f, 0.0f, 0.0f};
    camera.vertical_field_of_view = 90.0f;
    return camera;
}

Camera random_camera(RandomNumbers& numbers) {
    Camera camera;
    camera.eye = 10.0f * numbers.in_cube();
    camera.target = camera.eye + numbers.in_cube() + glm::vec3(0.0f, 0.0f, 2.0f);
    camera.vertical_field_of_view = 10.0f + 80.0f * numbers.unit();
    return camera;
}

const RayGeneration both[] = {RayGeneration::interpolated, RayGeneration::direct};

} // namespace

TEST_CASE("a ray goes through the centre of its pixel", "[01][rays]") {
    const auto context = make_context(ContextKind::automatic);
    for (const RayGeneration generation : both) {
        const auto rays = read_rays(generate_rays(camera_along_minus_z(), 2, 2, generation));
        REQUIRE(rays.size() == 4);
        // The bottom row first: centres at a quarter and three quarters of a rectangle from -1
        // to 1.
        const glm::vec3 expected[] = {
            {-0.5f, -0.5f, -1.0f}, {0.5f, -0.5f, -1.0f}, {-0.5f, 0.5f, -1.0f}, {0.5f, 0.5f, -1.0f}};
        for (std::size_t i = 0; i < 4; ++i) {
            CAPTURE(i);
            CHECK(rays[i].origin == glm::vec3(0.0f, 0.0f, 1.0f));
            // A quarter of a pixel would be off by 0.25.
            CHECK(glm::distance(rays[i].direction, expected[i]) < 1e-5f);
            CHECK(rays[i].t_min == 0.0f);
            CHECK(rays[i].t_max == std::numeric_limits<float>::max());
        }
    }
}

TEST_CASE("right is right and up is up in the picture", "[01][rays]") {
    const auto context = make_context(ContextKind::automatic);
    const Image image =
        show_directions(generate_rays(camera_along_minus_z(), 8, 8, RayGeneration::interpolated));
    // Red grows with x to the right, green with y to the top, which is row 0; blue is small, for
    // -z.
    CHECK(image.at(7, 4).x > image.at(0, 4).x);
    CHECK(image.at(4, 0).y > image.at(4, 7).y);
    CHECK(image.at(4, 4).z < 0.1f);
}

TEST_CASE("directions computed on the GPU have the bits of the mirror", "[01][agreement]") {
    const int seed = 3;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const auto context = make_context(ContextKind::automatic);
    using Mirror = mirror::walks::every_triangle<float>;
    Mirror mirror{};
    const int width = 37;
    const int height = 23;
    for (int trial = 0; trial < 20; ++trial) {
        const Camera camera = random_camera(numbers);
        const auto rays = read_rays(generate_rays(camera, width, height, RayGeneration::direct));
        const auto view =
            mirror::to_mirror<Mirror>(view_of(camera, static_cast<double>(width) / height));
        int different = 0;
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                const auto expected = mirror.primary_ray(
                    view, (static_cast<float>(column) + 0.5f) / static_cast<float>(width),
                    (static_cast<float>(row) + 0.5f) / static_cast<float>(height));
                const Ray& ray = rays[static_cast<std::size_t>(row * width + column)];
                different += same_bits(ray.direction, expected.direction) &&
                                     same_bits(ray.origin, expected.origin)
                                 ? 0
                                 : 1;
            }
        }
        CAPTURE(trial);
        CHECK(different == 0);
    }
}

TEST_CASE("directions are as exact as their rounding allows", "[01][reference]") {
    const int seed = 4;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const auto context = make_context(ContextKind::automatic);
    for (int trial = 0; trial < 20; ++trial) {
        CAPTURE(trial);
        const Camera camera = random_camera(numbers);
        const auto errors = [&](RayGeneration generation) {
            const auto rays = read_rays(generate_rays(camera, 64, 64, generation));
            const auto all = direction_errors(rays, camera, 64, 64);
            return *std::max_element(all.begin(), all.end());
        };
        // Up to 90 degrees and at aspect ratio 1, |lower_left| <= sqrt(3), |right| and |up| <= 2.
        // In units of 2^-24: the three are rounded once (5.8), s and t once (4), their products
        // once (4), the two sums once (3.8 + 1.8). The direction is no shorter than 1, so its
        // largest component is over 0.57 and its ulp 2^-24.
        CHECK(errors(RayGeneration::direct) < 20.0f);
        // OpenGL leaves open how a rasterizer interpolates. A hundredth of a pixel (which is at
        // most 2/64 wide) is what no picture shows.
        CHECK(errors(RayGeneration::interpolated) < 0.01f * 2.0f / 64.0f * 0x1p24f);
    }
}

TEST_CASE("the picture of chapter 01 is the expected one", "[01][picture]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = load_scene("mirrors", 1.0f);
    const Image image =
        show_directions(generate_rays(scene.camera, 256, 256, RayGeneration::interpolated));
    CHECK(unexpected_pixels(image, "01_rays") == 0);
}
