#pragma once

#include "gpu/live_mask.h"
#include "gpu/program.h"
#include "gpu/texture.h"

#include <functional>
#include <initializer_list>
#include <optional>
#include <vector>

namespace raysteps {

// Whether a drawn colour takes the place of the one that is there, or is added to it.
enum class Blend { replace, add };

// What covers the picture: one triangle, or a rectangle of two whose corners carry values to
// interpolate.
enum class Shape { triangle, rectangle };

// Draws the shape over a picture of that size, with the program and into the framebuffer that are
// current.
void cover(Shape shape, int width, int height);

// What a full-screen pass writes: textures of equal size and layout, in the order of the pass's
// outputs; each layer of an array is a target of its own.
struct Targets {
    std::vector<std::reference_wrapper<const Texture>> textures;
    const LiveMask* live = nullptr; // where given, only live pixels are drawn
    Blend blend = Blend::replace;
    Shape shape = Shape::triangle;
    std::optional<glm::uvec4> clear_to{}; // what textures of integers hold where nothing is drawn
};

// Runs the program's fragment pass once for every pixel (of the mask, where one is given).
void draw(const Program& program, const Targets& targets);

// The same, and how many pixels it drew (it discards the others): an occlusion query.
long draw_and_count(const Program& program, const Targets& targets);

// How many pixels the passes in `drawing` draw.
long count_drawn(const std::function<void()>& drawing);

// Sets every texel to zero.
void clear(const Texture& texture);

// Sets every texel of a texture of integers.
void clear(const Texture& texture, const glm::uvec4& value);

// Runs the program once for each of `count` vertices, as points of one pixel wherever its vertex
// pass puts them, and adds what it draws to the texture. Points are added in their order, so the
// sums are the same each time.
void add_points(const Program& program, const Texture& texture, int count);

} // namespace raysteps
