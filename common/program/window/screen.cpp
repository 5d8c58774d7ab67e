#include "program/window/screen.h"

#include <glm/common.hpp>

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace raysteps {

namespace {

constexpr int coarsest = 16;
constexpr double fluent_frame = 0.1; // seconds; Card, Moran and Newell (1983): seems immediate
constexpr double rest = 0.15;        // seconds without a move after which a drag seems to be over

bool same_camera(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up &&
           a.vertical_field_of_view == b.vertical_field_of_view;
}

} // namespace

int affordable_coarseness(int coarseness, double seconds) {
    int affordable = coarsest;
    while (affordable > 1) {
        const double ratio = 2.0 * coarseness / affordable;
        if (seconds * ratio * ratio > fluent_frame) {
            break;
        }
        affordable /= 2;
    }
    return affordable;
}

int next_coarseness(int shown, int affordable) {
    if (shown == 0) {
        return affordable;
    }
    return std::max(1, std::min(shown / 2, affordable));
}

double wait_before_frame(int shown, double seconds_at_rest) {
    if (shown == 0) {
        return 0.0;
    }
    if (shown == 1) {
        return std::numeric_limits<double>::infinity();
    }
    return std::max(0.0, rest - seconds_at_rest);
}

int coarse_side(int side, int coarseness) {
    return std::max(1, (side + coarseness / 2) / coarseness);
}

bool same_sight(const Sight& a, const Sight& b) {
    return a.width == b.width && a.height == b.height && same_camera(a.camera, b.camera);
}

Frame render_frame(const RenderPicture& render, const Sight& sight, int coarseness) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    Frame frame;
    frame.sight = sight;
    frame.coarseness = coarseness;
    frame.image = render(sight.camera, coarse_side(sight.width, coarseness),
                         coarse_side(sight.height, coarseness));
    frame.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return frame;
}

Texture screen_texture(const Image& image) {
    std::vector<glm::vec4> texels;
    texels.reserve(image.pixels.size());
    for (int row = image.height - 1; row >= 0; --row) {
        for (int column = 0; column < image.width; ++column) {
            const glm::vec3& pixel = image.at(column, row);
            const glm::vec3 shown =
                has_nan(pixel) ? nan_color : glm::clamp(pixel, glm::vec3(0.0f), glm::vec3(1.0f));
            texels.emplace_back(shown, 1.0f);
        }
    }
    Texture texture(TexelFormat::rgba32f, image.width, image.height);
    write_texels(texture, texels);
    return texture;
}

Screen::Screen() : program_("pass/show/show_image.frag") {
    glGenVertexArrays(1, &vertices_);
}

Screen::~Screen() {
    glDeleteVertexArrays(1, &vertices_);
}

void Screen::draw(const Texture& picture, int width, int height) {
    program_.set("picture", picture).set("size", glm::vec2(width, height));
    program_.use();
    glBindVertexArray(vertices_);
    glViewport(0, 0, width, height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    check_gl("drawing to the window");
}

std::filesystem::path screenshot_path(const std::filesystem::path& name) {
    for (int number = 1;; ++number) {
        std::filesystem::path path = name;
        path += "-" + std::to_string(number) + ".png";
        std::error_code error;
        // A link that points nowhere would be written through: it counts as taken. Where the
        // folder cannot be looked into, writing says why.
        if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
            return path;
        }
    }
}

} // namespace raysteps
