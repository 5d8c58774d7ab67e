#include "program/window/screen.h"

#include "image/draw_text.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
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

constexpr int overlay_inset = 12; // pixels between the window's edge and what lies over its picture

struct HelpLine {
    std::string input;
    std::string effect;
};

const std::array<HelpLine, 9>& help_lines() {
    static const std::array<HelpLine, 9> lines{{
        {"left mouse", "turn the scene"},
        {"shift left, middle", "move it"},
        {"right, wheel", "zoom"},
        {"control left", "tilt"},
        {"R", "back to the first view"},
        {"S", "save the picture"},
        {"C", "print the camera"},
        {"H", "hide these lines"},
        {"Q, Escape", "close"},
    }};
    return lines;
}

constexpr int margin = 16;
constexpr int gap = 24;    // between the columns
constexpr int leading = 4; // between the lines

// Linear: light letters on a dark ground, which is pleasant over any picture.
constexpr glm::vec3 ground_color{0.006f, 0.008f, 0.012f};
constexpr glm::vec3 letter_color{0.9f};

Image light_on_dark(Image text) {
    for (glm::vec3& pixel : text.pixels) {
        pixel = glm::mix(letter_color, ground_color, pixel);
    }
    return text;
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

ScreenPlace overlay_place(const Image& overlay, double scale, int window_width, int window_height) {
    const double room = 2.0 * overlay_inset;
    const double fitting = std::min(
        {scale, window_width / (overlay.width + room), window_height / (overlay.height + room)});
    const int width = std::max(1, static_cast<int>(fitting * overlay.width));
    const int height = std::max(1, static_cast<int>(fitting * overlay.height));
    const int inset = static_cast<int>(fitting * overlay_inset);
    return {inset, window_height - inset - height, width, height};
}

Screen::Screen() : program_("pass/show/show_image.frag") {
    glGenVertexArrays(1, &vertices_);
}

Screen::~Screen() {
    glDeleteVertexArrays(1, &vertices_);
}

void Screen::draw(const Texture& picture, const ScreenPlace& place, float opacity) {
    program_.set("picture", picture)
        .set("corner", glm::vec2(place.left, place.bottom))
        .set("size", glm::vec2(place.width, place.height));
    program_.use();
    glBindVertexArray(vertices_);
    glViewport(place.left, place.bottom, place.width, place.height);
    glEnable(GL_BLEND);
    glBlendColor(0.0f, 0.0f, 0.0f, opacity);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glBindVertexArray(0);
    check_gl("drawing to the window");
}

Image help_picture() {
    int input_width = 0;
    int effect_width = 0;
    for (const HelpLine& line : help_lines()) {
        input_width = std::max(input_width, text_width(line.input));
        effect_width = std::max(effect_width, text_width(line.effect));
    }
    const int line_height = text_line_height + leading;
    const int count = static_cast<int>(help_lines().size());
    Image picture = blank(margin + input_width + gap + effect_width + margin,
                          margin + count * line_height + margin, paper_color);
    int row = margin + leading;
    for (const HelpLine& line : help_lines()) {
        picture = paste(std::move(picture), draw_line(line.input), margin, row);
        picture =
            paste(std::move(picture), draw_line(line.effect), margin + input_width + gap, row);
        row += line_height;
    }
    return light_on_dark(std::move(picture));
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
