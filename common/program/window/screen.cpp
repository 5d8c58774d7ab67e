#include "program/window/screen.h"

#include "gpu/gl.h"
#include "image/image.h"

#include <glm/common.hpp>

#include <algorithm>
#include <vector>

namespace raysteps {

namespace {

constexpr int overlay_inset = 12; // pixels between the window's edge and what lies over its picture

} // namespace

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

} // namespace raysteps
