#include "scene/place_camera.h"

#include "catch.h"
#include "scene/coarse_view.h"
#include "scene/frame_scene.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "support/error_of.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace raysteps;

namespace {

Mesh inside_out(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
        std::swap(mesh.corners[i + 1], mesh.corners[i + 2]);
    }
    for (glm::vec3& normal : mesh.normals) {
        normal = -normal;
    }
    return mesh;
}

// A closed room, 6 by 3 by 5, with a table in it.
Scene room_scene() {
    Scene scene = add_mesh({}, inside_out(box({0, 0, 0}, {6, 3, 5})), Material{});
    scene = add_mesh(std::move(scene), box({2, 0, 2}, {3, 1, 3}), Material{});
    scene.name = "room";
    return scene;
}

// The triangles that the camera sees, a number for each of 64 x 64 pixels.
CoarseView seen_by(const Scene& scene, const Camera& camera) {
    CoarseView view;
    view.width = 64;
    view.height = 64;
    view.up_slope =
        std::tan(0.5 * glm::radians(static_cast<double>(camera.vertical_field_of_view)));
    view.right_slope = view.up_slope;
    const glm::dvec3 eye(camera.eye);
    return draw_coarsely(scene, eye,
                         view_frame(glm::dvec3(camera.target) - eye, glm::dvec3(camera.up)), view);
}

long pixels_of(const CoarseView& view, int first, int end) {
    return std::count_if(view.triangles.begin(), view.triangles.end(),
                         [&](int triangle) { return triangle >= first && triangle < end; });
}

std::string said_by(const Scene& scene) {
    return std::accumulate(scene.messages.begin(), scene.messages.end(), std::string());
}

} // namespace

TEST_CASE("a coarse view shows the nearest triangle and its side", "[scene][camera]") {
    Scene scene = add_mesh({}, quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}), Material{});
    scene = add_mesh(std::move(scene), quad({-9, -9, -1}, {9, -9, -1}, {9, 9, -1}, {-9, 9, -1}),
                     Material{});
    Camera camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 90.0f}; // 8 wide at the first quad
    const CoarseView view = seen_by(scene, camera);
    CHECK(pixels_of(view, 0, 2) == 16 * 16);
    CHECK(pixels_of(view, 2, 4) == 64 * 64 - 16 * 16);
    CHECK(view.depths[32 * 64 + 32] == Approx(4.0));
    CHECK(std::count(view.is_back.begin(), view.is_back.end(), true) == 0);
    camera = {{0, 0, -4}, {0, 0, 0}, {0, 1, 0}, 90.0f};
    const CoarseView behind = seen_by(scene, camera);
    CHECK(std::count(behind.is_back.begin(), behind.is_back.end(), true) == 64 * 64);
    // All directions of a cube's side are a sixth of the sphere.
    double angle = 0.0;
    for (std::size_t i = 0; i < view.triangles.size(); ++i) {
        angle += solid_angle_of(view, i);
    }
    CHECK(angle == Approx(4.0 * 3.14159265358979 / 6.0).epsilon(1e-3));
}

TEST_CASE("a triangle that reaches behind the eye is seen up to it", "[scene][camera]") {
    const Scene floor =
        add_mesh({}, quad({-9, -1, 9}, {9, -1, 9}, {9, -1, -9}, {-9, -1, -9}), Material{});
    const CoarseView view = seen_by(floor, {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90.0f});
    CHECK(view.triangles[5 * 64 + 32] >= 0); // below
    CHECK(view.triangles[60 * 64 + 32] < 0); // above
}

TEST_CASE("a compact model is framed as samples are, bit for bit", "[scene][camera]") {
    Scene scene = add_mesh({}, sphere({1, 2, 3}, 2.0f, 3), Material{});
    const Camera placed = place_camera(scene, 1.5f, {});
    const Camera framed = frame_camera(scene, 1.5f);
    CHECK(placed.eye == framed.eye);
    CHECK(placed.target == framed.target);
    CHECK(scene.messages.empty());
}

TEST_CASE("a floor does not shrink the things on it", "[scene][camera]") {
    const Mesh thing = sphere({3, 1, 2}, 1.0f, 3);
    const int triangles = static_cast<int>(thing.corners.size() / 3);
    Scene alone = add_mesh({}, thing, Material{});
    const long large = pixels_of(seen_by(alone, place_camera(alone, 1.0f, {})), 0, triangles);
    const Mesh flat_floor = quad({-90, 0, 90}, {90, 0, 90}, {90, 0, -90}, {-90, 0, -90});
    for (const Mesh& floor : {flat_floor, box({-90, -1, -90}, {90, 0, 90})}) {
        Scene scene = add_mesh(alone, floor, Material{});
        const long seen = pixels_of(seen_by(scene, place_camera(scene, 1.0f, {})), 0, triangles);
        CHECK(seen > large * 9 / 10);
    }
    // A floor alone, and a wall as large as it, are what there is to see.
    Scene floor = add_mesh({}, flat_floor, Material{});
    CHECK(place_camera(floor, 1.0f, {}).eye == frame_camera(floor, 1.0f).eye);
    Scene corner = add_mesh(floor, quad({-90, 0, -90}, {90, 0, -90}, {90, 90, -90}, {-90, 90, -90}),
                            Material{});
    CHECK(place_camera(corner, 1.0f, {}).eye == frame_camera(corner, 1.0f).eye);
}

TEST_CASE("a closed room is seen from inside and lit there", "[scene][camera]") {
    Scene scene = room_scene();
    scene.camera = place_camera(scene, 1.0f, {});
    const glm::vec3 eye = scene.camera.eye;
    CHECK(glm::clamp(eye, glm::vec3(0, 0, 0), glm::vec3(6, 3, 5)) == eye);
    CHECK_THAT(said_by(scene), contains_text("room: it is seen from inside"));
    const CoarseView view = seen_by(scene, scene.camera);
    CHECK(std::count(view.is_back.begin(), view.is_back.end(), true) == 0);
    CHECK(pixels_of(view, 0, 24) == 64 * 64);
    for (const Light& light : place_model_lights(scene, 1.0f)) {
        CHECK(glm::clamp(light.position, glm::vec3(0, 0, 0), glm::vec3(6, 3, 5)) == light.position);
    }
    // The same from outside, where it is asked for.
    CHECK(place_camera(scene, 1.0f, {.choice = CameraChoice::front}).eye.z > 5.0f);
    // A closed thing shows fronts.
    Scene solid = add_mesh({}, box({0, 0, 0}, {6, 3, 5}), Material{});
    CHECK(place_camera(solid, 1.0f, {}).eye == frame_camera(solid, 1.0f).eye);
}

TEST_CASE("a single sheet seen from behind is no room", "[scene][camera]") {
    Scene sheet = add_mesh({}, quad({-1, 1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}), Material{});
    CHECK(place_camera(sheet, 1.0f, {}).eye == frame_camera(sheet, 1.0f).eye);
}

TEST_CASE("a model with z up is upright where that is said, and a lying one is remarked",
          "[scene][camera]") {
    // A pyramid on the plane z = 0.
    Mesh pyramid;
    for (const glm::vec3& corner :
         {glm::vec3(-1, -1, 0), glm::vec3(0, 0, 3), glm::vec3(-1, 1, 0), glm::vec3(-1, 1, 0),
          glm::vec3(0, 0, 3), glm::vec3(1, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, 3),
          glm::vec3(-1, -1, 0), glm::vec3(-1, -1, 0), glm::vec3(-1, 1, 0), glm::vec3(1, 0, 0)}) {
        pyramid.corners.push_back(corner);
        pyramid.normals.emplace_back(0, 0, 1);
    }
    Scene scene = add_mesh({}, pyramid, Material{});
    place_camera(scene, 1.0f, {});
    CHECK_THAT(said_by(scene), contains_text("Add --up z"));
    scene.messages.clear();
    const Camera upright = place_camera(scene, 1.0f, {.up = UpAxis::z});
    CHECK(upright.up == glm::vec3(0, 0, 1));
    CHECK(upright.eye.z > upright.target.z);
    CHECK(upright.eye.y < upright.target.y);
    CHECK(scene.messages.empty());
    // A cube stands on any side.
    Scene cube = add_mesh({}, box({-1, -1, -1}, {1, 1, 1}), Material{});
    place_camera(cube, 1.0f, {});
    CHECK(cube.messages.empty());
}

TEST_CASE("named cameras look along the axes", "[scene][camera]") {
    Scene cube = add_mesh({}, box({-1, -1, -1}, {1, 1, 1}), Material{});
    const auto looks = [&](CameraChoice choice, UpAxis up) {
        const Camera camera = place_camera(cube, 1.0f, {.choice = choice, .up = up});
        return glm::normalize(camera.target - camera.eye);
    };
    CHECK(looks(CameraChoice::front, UpAxis::y) == glm::vec3(0, 0, -1));
    CHECK(looks(CameraChoice::left, UpAxis::y) == glm::vec3(1, 0, 0));
    CHECK(looks(CameraChoice::top, UpAxis::y) == glm::vec3(0, -1, 0));
    CHECK(looks(CameraChoice::front, UpAxis::z) == glm::vec3(0, 1, 0));
    CHECK(looks(CameraChoice::top, UpAxis::z) == glm::vec3(0, 0, -1));
    CHECK_THAT(error_of([&] { looks(CameraChoice::file, UpAxis::y); }),
               contains_text("has no camera"));
    const Camera own{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 50.0f};
    cube.file_camera = own;
    CHECK(place_camera(cube, 1.0f, {}).eye == own.eye);
    // The same direction, seen as far away as the middle of what there is.
    CHECK(glm::distance(place_camera(cube, 1.0f, {}).target, glm::vec3(0.0f)) < 1e-6f);
    CHECK_THAT(said_by(cube), contains_text("seen by the camera of its file"));
}

TEST_CASE("a camera of the file that shows next to nothing is not taken by itself",
          "[scene][camera]") {
    Scene scene = add_mesh({}, sphere({0, 0, 0}, 1.0f, 8), Material{});
    scene.file_camera = Camera{{0, 0, 5}, {0, 0, 9}, {0, 1, 0}, 40.0f};
    CHECK(place_camera(scene, 1.0f, {}).eye == frame_camera(scene, 1.0f).eye);
    CHECK_THAT(said_by(scene), contains_text("shows hardly anything of it"));
    CHECK(place_camera(scene, 1.0f, {.choice = CameraChoice::file}).eye == glm::vec3(0, 0, 5));
}

TEST_CASE("dark and light models are lit to be seen", "[scene][camera]") {
    const auto strength = [](float grey) {
        Material material;
        material.diffuse = glm::vec3(grey);
        Scene scene = add_mesh({}, sphere({0, 0, 0}, 1.0f, 3), material);
        scene.camera = place_camera(scene, 1.0f, {});
        return place_model_lights(scene, 1.0f)[0].color.y;
    };
    const float usual = strength(0.8f);
    CHECK(usual == place_lights(Camera{})[0].color.y);
    // 0.2 in sRGB is 0.033; half of a ball shows at most 0.02 * 1.1 at its brightest.
    CHECK(strength(0.02f) > 2.0f * usual);
}
