#include "catch.h"
#include "mirror/walks.h"
#include "mirror/whitted.h"
#include "replayed.h"
#include "scene/load_scene.h"
#include "scene/view.h"
#include "support/same_bits.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace raysteps;

TEST_CASE("a path has the rays that the mirror asks for to shade the pixel", "[replay][path]") {
    const Scene scene = load_scene("mirrors", 1.0f);
    const Replayed replayed(scene, "bvh_ordered",
                            reach_of(origins_of(scene.camera), scene.corners));
    const View view = view_of(scene.camera, 1.0);
    auto mirror = mirror::mirror_of<mirror::walks::every_triangle<float>>(replayed.buffers);
    int bounces = 0;
    int blocked = 0;
    for (int row = 2; row < 32; row += 5) {
        for (int column = 2; column < 32; column += 5) {
            const Ray ray = pixel_ray(view, 32, 32, column, row);
            const std::vector<PathRay> path =
                record_path({scene, replayed.buffers, replayed.recorder}, ray, 3);
            REQUIRE(!path.empty());
            CHECK(path.front().role == RayRole::camera);
            CHECK(same_bits(path.front().walk.ray, ray));
            // What the rays found, put together as color_along does, is the colour of the pixel.
            glm::vec3 color(0.0f);
            glm::vec3 weight(1.0f);
            for (std::size_t i = 0; i < path.size();) {
                const RecordedWalk& walk = path[i].walk;
                bounces += path[i].role == RayRole::mirror ? 1 : 0;
                ++i;
                if (walk.hit.triangle == no_triangle) {
                    color += weight * scene.background;
                    continue;
                }
                const auto surface =
                    mirror.surface_at(mirror::to_mirror<decltype(mirror)>(walk.ray),
                                      {walk.hit.t, walk.hit.u, walk.hit.v, walk.hit.triangle});
                color += weight * surface.material.emission;
                for (; i < path.size() && path[i].role == RayRole::shadow; ++i) {
                    const auto light = static_cast<std::size_t>(path[i].number - 1);
                    CHECK(path[i].walk.question == Question::any);
                    if (path[i].walk.hit.triangle != no_triangle) {
                        ++blocked;
                        continue;
                    }
                    color += weight * mirror.diffuse_light(surface, scene.lights[light].position,
                                                           scene.lights[light].color);
                }
                weight *= surface.material.specular;
            }
            const glm::vec3 expected =
                mirror::color_along(mirror, mirror::to_mirror<decltype(mirror)>(ray), scene, 3);
            CHECK(same_bits(color, expected));
        }
    }
    CHECK(bounces > 3);
    CHECK(blocked > 0);
}

TEST_CASE("rays of a path are named by what they are for", "[replay][path]") {
    PathRay ray;
    CHECK(ray_name(ray) == "camera ray");
    ray.role = RayRole::shadow;
    ray.number = 2;
    CHECK(ray_name(ray) == "shadow ray to light 2");
    ray.role = RayRole::mirror;
    CHECK(ray_name(ray) == "mirror ray 2");
}

TEST_CASE("pixels are counted from the top left", "[replay][path]") {
    const Camera camera; // from +z to the origin
    const View view = view_of(camera, 1.0);
    const Ray corner = pixel_ray(view, 4, 4, 0, 0);
    CHECK(corner.direction.x < 0.0f);
    CHECK(corner.direction.y > 0.0f);
    const std::vector<Ray> all = pixel_rays(view, 4, 4);
    REQUIRE(all.size() == 16);
    CHECK(same_bits(all[0], corner));
    CHECK(same_bits(all[4 * 3 + 1], pixel_ray(view, 4, 4, 1, 3)));
}

TEST_CASE("a ray through a slab of glass is bent twice and goes on in its direction",
          "[replay][path]") {
    Material glass;
    glass.refractive_index = 1.5f;
    glass.opacity = 0.0f;
    glass.illumination_model = 7;
    const Scene scene = add_mesh(Scene{}, box({-9.0f, -9.0f, -1.0f}, {9.0f, 9.0f, 0.0f}), glass);
    const Replayed replayed(scene, "bvh_ordered", 10.0f);
    const Ray slanting{{-1.0f, 0.0f, 1.0f}, {1.0f, 0.0f, -1.0f}, 0.0f, no_end};
    const std::vector<PathRay> path =
        record_path({scene, replayed.buffers, replayed.recorder}, slanting, 2);
    REQUIRE(path.size() >= 3);
    CHECK(path[1].role == RayRole::refraction);
    CHECK(path[2].role == RayRole::refraction);
    // Snell: the sine of 45 degrees over 1.5, and back again.
    const glm::vec3 inside = path[1].walk.ray.direction;
    CHECK(inside.x / glm::length(inside) == Approx(std::sqrt(0.5) / 1.5).epsilon(1e-6));
    const glm::vec3 behind = path[2].walk.ray.direction;
    CHECK(behind.x / glm::length(behind) == Approx(std::sqrt(0.5)).epsilon(1e-6));
    // 5 in 100 are reflected at 45 degrees, which is over 1 in 50.
    CHECK(std::any_of(path.begin(), path.end(),
                      [](const PathRay& ray) { return ray.role == RayRole::mirror; }));
    CHECK(ray_name(path[1]) == "refracted ray 1");
}
