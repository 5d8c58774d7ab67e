#include "catch.h"
#include "gpu/context.h"
#include "gpu/draw.h"
#include "gpu/texture.h"
#include "sentence_of.h"

#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

using namespace raysteps;

namespace {

using Numbers = std::numeric_limits<float>;

glm::uvec4 bits_of(const glm::vec4& texel) {
    return std::bit_cast<glm::uvec4>(texel);
}

std::vector<glm::uvec4> random_bits(unsigned seed, std::size_t count) {
    std::mt19937 generator(seed);
    std::vector<glm::uvec4> texels(count);
    for (glm::uvec4& texel : texels) {
        texel = {generator(), generator(), generator(), generator()};
    }
    return texels;
}

} // namespace

TEST_CASE("a texture gives back every bit of floats that are numbers", "[gpu][texture]") {
    const auto context = make_context(ContextKind::automatic);
    const std::vector<glm::vec4> texels{
        {0.0f, -0.0f, 1.0f, -1.0f},
        {Numbers::max(), Numbers::lowest(), Numbers::min(), Numbers::epsilon()},
        {Numbers::infinity(), -Numbers::infinity(), 0.1f, 16777217.0f},
        {Numbers::denorm_min(), -Numbers::denorm_min(), 1e-40f, 3e38f},
        {1.0f, 2.0f, 3.0f, 4.0f},
        {5.0f, 6.0f, 7.0f, 8.0f}};
    const Texture texture(TexelFormat::rgba32f, 3, 2);
    write_texels(texture, texels);
    const std::vector<glm::vec4> read = read_floats(texture);
    REQUIRE(read.size() == texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i) {
        CAPTURE(i);
        CHECK(bits_of(read[i]) == bits_of(texels[i]));
    }
}

// OpenGL does not promise which NaN comes back: hits, whose bits count, are integers.
TEST_CASE("a texture gives back a NaN as a NaN", "[gpu][texture]") {
    const auto context = make_context(ContextKind::automatic);
    const std::vector<glm::vec4> texels{glm::vec4(Numbers::quiet_NaN())};
    const Texture texture(TexelFormat::rgba32f, 1, 1);
    write_texels(texture, texels);
    CHECK(std::isnan(read_floats(texture).front().x));
    CHECK(std::isnan(read_floats(texture).front().w));
}

TEST_CASE("a texture of integers gives back any bits", "[gpu][texture]") {
    const unsigned seed = 7;
    CAPTURE(seed);
    const auto context = make_context(ContextKind::automatic);
    const std::vector<glm::uvec4> texels = random_bits(seed, std::size_t{61} * 17);
    const Texture texture(TexelFormat::rgba32ui, 61, 17);
    write_texels(texture, texels);
    CHECK(read_integers(texture) == texels);
}

TEST_CASE("a pass copies integers with all their bits", "[gpu][texture][draw]") {
    const unsigned seed = 8;
    CAPTURE(seed);
    const auto context = make_context(ContextKind::automatic);
    std::vector<glm::uvec4> texels = random_bits(seed, std::size_t{33} * 5);
    texels.front() = {0x7fc01234u, 0x7f800001u, 0x00000001u, 0x80000000u}; // NaNs, a denormal, -0
    const Texture from(TexelFormat::rgba32ui, 33, 5);
    const Texture to(TexelFormat::rgba32ui, 33, 5);
    write_texels(from, texels);
    Program program("pass/trace/probe_bits.frag");
    program.set("bits", from);
    draw(program, {.textures = {to}});
    CHECK(read_integers(to) == texels);
}

TEST_CASE("a cleared texture holds zeros", "[gpu][texture]") {
    const auto context = make_context(ContextKind::automatic);
    const Texture floats(TexelFormat::rgba32f, 2, 1);
    write_texels(floats, std::vector<glm::vec4>(2, glm::vec4(3.0f)));
    clear(floats);
    CHECK(read_floats(floats) == std::vector<glm::vec4>(2, glm::vec4(0.0f)));
    const Texture integers(TexelFormat::rgba32ui, 2, 1);
    write_texels(integers, std::vector<glm::uvec4>(2, glm::uvec4(3u)));
    clear(integers);
    CHECK(read_integers(integers) == std::vector<glm::uvec4>(2, glm::uvec4(0u)));
}

TEST_CASE("a moved texture keeps its texels", "[gpu][texture]") {
    const auto context = make_context(ContextKind::automatic);
    const std::vector<glm::uvec4> texels{{1u, 2u, 3u, 4u}};
    Texture first(TexelFormat::rgba32ui, 1, 1);
    write_texels(first, texels);
    Texture second(std::move(first));
    CHECK(read_integers(second) == texels);
    Texture third(TexelFormat::rgba32f, 2, 2);
    third = std::move(second);
    CHECK(third.format() == TexelFormat::rgba32ui);
    CHECK(third.width() == 1);
    CHECK(read_integers(third) == texels);
}

TEST_CASE("a texture over the machine's limit is refused with both sizes", "[gpu][texture]") {
    const auto context = make_context(ContextKind::automatic);
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    const std::string too_wide =
        machine_sentence_of([&] { Texture(TexelFormat::rgba32f, limit + 1, 1); });
    CHECK_THAT(too_wide,
               starts_with_text("A texture of " + std::to_string(limit + 1) + " x 1 is asked for"));
    CHECK_THAT(too_wide, contains_text("Take another --size."));
    CHECK_THAT(machine_sentence_of([] { Texture(TexelFormat::rgba32f, 4, 0); }),
               starts_with_text("A texture of 4 x 0 is asked for"));
}

TEST_CASE("a buffer over the machine's limit is refused with both sizes", "[gpu][texture]") {
    const auto context = make_context(ContextKind::automatic);
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    // Memory that nobody writes to takes no place.
    const std::size_t count = static_cast<std::size_t>(limit) + 1;
    const auto numbers = std::make_unique_for_overwrite<std::int32_t[]>(count);
    const std::string sentence = machine_sentence_of(
        [&] { BufferTexture(std::span<const std::int32_t>(numbers.get(), count)); });
    CHECK_THAT(sentence, starts_with_text("A buffer texture of " + std::to_string(count) +
                                          " texels is asked for"));
    CHECK_THAT(sentence, contains_text("Take a scene with fewer triangles."));
}

TEST_CASE("an empty buffer is valid", "[gpu][texture]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK_NOTHROW(BufferTexture(std::span<const glm::vec4>()));
    CHECK_NOTHROW(BufferTexture(std::span<const std::int32_t>()));
}
