#include "scene/sample_cornell_box.h"

#include "scene/mesh.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"

#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace raysteps {

namespace {

// The measured spectra under CIE standard illuminant D65 and the CIE 1931 observer (as fitted by
// Wyman, Sloan and Shirley, "Simple analytic approximations to the CIE XYZ color matching
// functions", 2013), as linear RGB.
constexpr glm::vec3 white{0.738f, 0.736f, 0.740f};
constexpr glm::vec3 red{0.489f, 0.051f, 0.051f};
constexpr glm::vec3 green{0.069f, 0.397f, 0.087f};

constexpr float lamp_height = 548.0f;

// The walls turn their fronts to the room.
Mesh floor_ceiling_and_back() {
    const Mesh floor = quad({552.8f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 559.2f},
                            {549.6f, 0.0f, 559.2f});
    const Mesh ceiling = quad({556.0f, 548.8f, 0.0f}, {556.0f, 548.8f, 559.2f},
                              {0.0f, 548.8f, 559.2f}, {0.0f, 548.8f, 0.0f});
    const Mesh back = quad({549.6f, 0.0f, 559.2f}, {0.0f, 0.0f, 559.2f}, {0.0f, 548.8f, 559.2f},
                           {556.0f, 548.8f, 559.2f});
    return join(join(floor, ceiling), back);
}

Mesh right_wall() {
    return quad({0.0f, 0.0f, 559.2f}, {0.0f, 0.0f, 0.0f}, {0.0f, 548.8f, 0.0f},
                {0.0f, 548.8f, 559.2f});
}

Mesh left_wall() {
    return quad({552.8f, 0.0f, 0.0f}, {549.6f, 0.0f, 559.2f}, {556.0f, 548.8f, 559.2f},
                {556.0f, 548.8f, 0.0f});
}

Mesh lamp() {
    return quad({343.0f, lamp_height, 227.0f}, {343.0f, lamp_height, 332.0f},
                {213.0f, lamp_height, 332.0f}, {213.0f, lamp_height, 227.0f});
}

// A block of this height over the base, whose corners run counter-clockwise as seen from above.
Mesh block(const std::array<glm::vec3, 4>& base, float height) {
    const glm::vec3 up{0.0f, height, 0.0f};
    Mesh mesh = quad(base[0] + up, base[1] + up, base[2] + up, base[3] + up);
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec3 from = base[i];
        const glm::vec3 to = base[(i + 1) % 4];
        mesh = join(std::move(mesh), quad(from, to, to + up, from + up));
    }
    return mesh;
}

Mesh short_block() {
    return block({{{130.0f, 0.0f, 65.0f},
                   {82.0f, 0.0f, 225.0f},
                   {240.0f, 0.0f, 272.0f},
                   {290.0f, 0.0f, 114.0f}}},
                 165.0f);
}

Mesh tall_block() {
    return block({{{423.0f, 0.0f, 247.0f},
                   {265.0f, 0.0f, 296.0f},
                   {314.0f, 0.0f, 456.0f},
                   {472.0f, 0.0f, 406.0f}}},
                 330.0f);
}

// A film of 25 mm behind a lens of 35 mm.
Camera measured_camera() {
    Camera camera;
    camera.eye = {278.0f, 273.0f, -800.0f};
    camera.target = {278.0f, 273.0f, 0.0f};
    camera.vertical_field_of_view =
        static_cast<float>(glm::degrees(2.0 * std::atan(25.0 / 2.0 / 35.0)));
    return camera;
}

} // namespace

Scene sample_cornell_box() {
    Material lamp_material = matte("lamp", glm::vec3(0.78f));
    lamp_material.emission = {1.0f, 0.95f, 0.85f};

    Scene scene;
    scene = add_mesh(std::move(scene), floor_ceiling_and_back(), matte("white", white));
    scene = add_mesh(std::move(scene), right_wall(), matte("green", green));
    scene = add_mesh(std::move(scene), left_wall(), matte("red", red));
    scene = add_mesh(std::move(scene), short_block(), matte("short block", white));
    scene = add_mesh(std::move(scene), tall_block(), matte("tall block", white));
    scene = add_mesh(std::move(scene), lamp(), lamp_material);
    scene.lights = {{{278.0f, 540.0f, 279.5f}, {0.90f, 0.85f, 0.76f}},
                    {measured_camera().eye, glm::vec3(0.12f)}};
    scene.camera = measured_camera();
    scene.background = glm::vec3(0.0f);
    return scene;
}

} // namespace raysteps
