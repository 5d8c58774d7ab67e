#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "mirror/effects.h"
#include "mirror/mirror_scene.h"
#include "mirror/trace_by_mirror.h"
#include "mirror/walks.h"
#include "program/window/controls.h"
#include "scene/shapes.h"
#include "scene/view.h"
#include "structure/padding.h"
#include "support/walk_hits.h"
#include "trace/trace_options.h"

#include <glm/common.hpp>

#include <map>

using namespace raysteps;

// Wherever rays start, the structures must have been built for it.

namespace {

using Mirror = mirror::EffectParts<float>;

Scene balls_on_a_floor() {
    Mesh mesh = quad({-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 0, -5});
    mesh = join(mesh, sphere({-1.0f, 0.8f, 0.0f}, 0.8f, 3));
    mesh = join(mesh, sphere({1.2f, 1.0f, -1.0f}, 1.0f, 3));
    Scene scene = add_mesh(Scene{}, mesh, Material{});
    scene.camera.eye = {0, 2, 6};
    scene.camera.target = {0, 0.8f, 0};
    scene.camera.focus_distance = 6.0f;
    return scene;
}

// Rays of random pixels through random points of the lens, by the text of the shader.
std::vector<Ray> lens_rays(RandomNumbers& numbers, const Camera& camera, int count) {
    Mirror mirror{};
    const View view = view_of(camera, 1.0);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 direction =
            view.lower_left + numbers.unit() * view.right + numbers.unit() * view.up;
        Mirror::View seen{view.eye, view.lower_left, view.right, view.up};
        Mirror::SquarePoint square;
        square.x = i % 4 == 0 ? 1.0f - 0x1p-24f : numbers.unit(); // many on the rim
        square.y = numbers.unit();
        const auto ray = mirror.lens_ray(
            mirror::to_mirror<Mirror>({camera.eye, direction, 0.0f, no_end}), seen,
            0.5f * camera.aperture, camera.focus_distance, mirror.point_of_disc(square));
        rays.push_back({ray.origin, ray.direction, ray.t_min, ray.t_max});
    }
    return rays;
}

// Of all walks, how many hits are not those of the loop.
std::size_t count_unlike(const Scene& scene, std::span<const Ray> rays, float reach) {
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> loop = mirror_triangle_tests().at("watertight")(buffers, {}, rays);
    std::size_t unlike = 0;
    for (const auto& [name, trace] : mirror_walks()) {
        const BuiltStructure built = family_of(name).build(scene.corners, {reach, {}});
        unlike += count_different(trace(buffers, built.packed, rays), loop);
    }
    return unlike;
}

} // namespace

TEST_CASE("every ray through a lens starts in the box of the camera's origins", "[origins]") {
    const int seed = 71;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (int i = 0; i < 200; ++i) {
        Camera camera;
        camera.eye = std::exp2(20.0f * numbers.unit() - 10.0f) * numbers.in_cube();
        camera.target = camera.eye + numbers.in_cube() + glm::vec3(0.0f, 0.0f, 1.5f);
        camera.aperture = std::exp2(40.0f * numbers.unit() - 20.0f);
        camera.focus_distance = 1.0f + numbers.unit();
        const Box box = origins_of(camera);
        for (const Ray& ray : lens_rays(numbers, camera, 100)) {
            REQUIRE(glm::clamp(ray.origin, box.lower, box.upper) == ray.origin);
        }
    }
}

TEST_CASE("a pinhole has one origin", "[origins]") {
    const Camera camera;
    CHECK(origins_of(camera).lower == camera.eye);
    CHECK(origins_of(camera).upper == camera.eye);
}

TEST_CASE("through a lens of any width every structure finds the bits of the loop", "[origins]") {
    const int seed = 72;
    Scene scene = balls_on_a_floor();
    std::size_t unlike_by_the_eye = 0;
    for (const float aperture : {1.0f, 1e5f, 1e6f}) {
        CAPTURE(seed, aperture);
        RandomNumbers numbers(seed);
        scene.camera.aperture = aperture;
        const std::vector<Ray> rays = lens_rays(numbers, scene.camera, 10000);
        CHECK(count_unlike(scene, rays, reach_of(origins_of(scene.camera), scene.corners)) == 0);
        const Box eye{scene.camera.eye, scene.camera.eye};
        unlike_by_the_eye += count_unlike(scene, rays, reach_of(eye, scene.corners));
    }
    CHECK(unlike_by_the_eye > 0); // so the rays can tell
}

TEST_CASE("a window lets no camera out of the reach of its structures", "[origins]") {
    const int seed = 73;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    Scene scene = balls_on_a_floor();
    scene.camera.aperture = 0.5f;
    PictureOptions picture;
    picture.window = true;
    const float reach = camera_reach(picture, scene);
    Controls controls = start_controls(scene.camera);
    controls.window_size = {640, 480};
    for (int i = 0; i < 2000; ++i) {
        const Button button = i % 3 == 0 ? Button::left : Button::middle;
        controls = press_button(std::move(controls), button, {});
        controls =
            move_cursor(std::move(controls), {640.0f * numbers.unit(), 480.0f * numbers.unit()});
        controls = release_button(std::move(controls), button);
        controls = scroll(std::move(controls), 2.0f * numbers.unit() - 1.2f);
        REQUIRE(reach_of(origins_of(controls.camera), scene.corners) <= reach);
    }
    CHECK(controls.camera.eye != scene.camera.eye);
}

TEST_CASE("small scenes far from zero have a reach for rays that leave their surfaces",
          "[origins]") {
    // Such a ray starts 64 * 2^-24 of the largest coordinate beside the box of side 2.
    const Box far_away{glm::vec3(1e7f), glm::vec3(1e7f + 2.0f)};
    CHECK(usual_reach(far_away, 0.0) >= 2.0 + 64.0 * 0x1p-24 * 1e7);
    const Box at_zero{glm::vec3(-1.0f), glm::vec3(1.0f)};
    CHECK(usual_reach(at_zero, 0.0) == 8.0);
    CHECK(usual_reach(at_zero, 9.0) == 9.0);
}
