// A window with a cheap picture, for the test that moves mouse and keys: a sky whose colors tell
// the direction, and a ball at the origin. `show_sky NAME [slow | fails_when_moved | live]`
#include "basics/error.h"
#include "program/show.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace raysteps;

const std::vector<glm::vec3> ball_colors{{1.0f, 0.2f, 0.05f}, {0.05f, 1.0f, 0.2f}};
glm::vec3 ball_color = ball_colors[0];

glm::vec3 color_of(const Camera& camera, const glm::vec3& direction) {
    const glm::vec3 to_origin = -camera.eye;
    const glm::vec3 beside = to_origin - glm::dot(to_origin, direction) * direction;
    const bool is_on_ball = glm::length(beside) < 0.5f;
    return is_on_ball ? ball_color : 0.5f * (direction + 1.0f);
}

Image sky(const Camera& camera, int width, int height) {
    Image image(width, height);
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward);
    const float half_height = std::tan(glm::radians(0.5f * camera.vertical_field_of_view));
    const float pixel = 2.0f * half_height / static_cast<float>(height);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const float x = pixel * (static_cast<float>(column) + 0.5f - 0.5f * width);
            const float y = pixel * (0.5f * height - 0.5f - static_cast<float>(row));
            image.at(column, row) = color_of(camera, glm::normalize(forward + x * right + y * up));
        }
    }
    return image;
}

Image render(const Camera& camera, int width, int height, const std::string& mode) {
    if (mode == "fails_when_moved" && camera.eye != Camera{}.eye) {
        throw MachineError("The renderer fails on purpose. Leave the mouse alone.");
    }
    if (mode == "slow") {
        std::cout << "frame " << width << "x" << height << "\n" << std::flush;
        std::this_thread::sleep_for(std::chrono::microseconds(20) * (width * height));
    }
    return sky(camera, width, height);
}

void color_ball(const std::string& word) {
    if (word == "none") {
        throw InputError("There is no such ball. Take another.");
    }
    ball_color = ball_colors[word == "red" ? 0 : 1];
}

// The file NAME.bad stands for a shader that does not compile.
LiveOffer offer_of(const std::string& name) {
    return {.choices = {{.name = "ball",
                         .key = 'b',
                         .words = {"red", "green", "none"},
                         .take = color_ball}},
            .read_shaders =
                [=] {
                    if (std::filesystem::exists(name + ".bad")) {
                        throw MachineError("sky.glsl:12: syntax error");
                    }
                },
            .view_command =
                [](const SeenPixel& pixel) {
                    return "show " + std::to_string(pixel.column) + "," + std::to_string(pixel.row);
                },
            .notes = [] { return std::vector<std::string>{"a note"}; }};
}

} // namespace

int main(int argc, char** argv) {
    const std::string name = argc > 1 ? argv[1] : "sky";
    const std::string mode = argc > 2 ? argv[2] : "";
    try {
        const auto context = make_window_context(320, 240, Visibility::shown);
        show_in_window(
            *context, Camera{}, name,
            [&](const Camera& camera, int width, int height) {
                return render(camera, width, height, mode);
            },
            mode == "live" ? offer_of(name) : LiveOffer{});
    } catch (const Error& error) {
        std::cerr << "show_sky: " << error.what() << "\n";
        return static_cast<int>(error.code());
    }
    return 0;
}
