#include "gpu/limits.h"

#include "basics/error.h"
#include "gpu/draw.h"

#include <algorithm>
#include <array>
#include <string>

namespace raysteps {

namespace {

// What 16 rays that share a budget need for a launch of a walk: rounds, and the way down and up a
// tree that may come on top of them.
constexpr int least_loop_budget = 8192;

int measure_loop_budget() {
    Program program("pass/trace/probe_loop.frag");
    program.set("rounds", no_loop_limit);
    const Texture counted(TexelFormat::rgba32ui, 4, 4);
    draw(program, {{counted}});
    unsigned fewest = no_loop_limit;
    for (const glm::uvec4& texel : read_integers(counted)) {
        fewest = std::min(fewest, texel.x);
    }
    return static_cast<int>(fewest);
}

// Bits that a texture and a fetch must return as they are: the smallest denormal, a NaN's, and all
// of them.
void check_bits() {
    const std::array<glm::uvec4, 1> bits{glm::uvec4{1u, 0x7fc00001u, 0xffffffffu, 0x80000000u}};
    const Texture texture(TexelFormat::rgba32ui, 1, 1);
    write_texels(texture, bits);
    Program program("pass/trace/probe_bits.frag");
    program.set("bits", texture);
    const Texture copied(TexelFormat::rgba32ui, 1, 1);
    draw(program, {{copied}});
    if (read_integers(copied).front() != bits.front()) {
        throw MachineError("This machine's OpenGL changes the bits of integer textures, so hits "
                           "would be wrong. Update the driver, or try --context osmesa.");
    }
}

} // namespace

int most_buffer_texels() {
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    return texels;
}

Limits measure_limits() {
    Limits limits{};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limits.texture_size);
    check_bits();
    limits.loop_budget = measure_loop_budget();
    if (limits.loop_budget < least_loop_budget) {
        throw MachineError("This machine's OpenGL stops a loop after " +
                           std::to_string(limits.loop_budget) +
                           " rounds, which is too few for a walk. Update the driver, or try "
                           "--context osmesa.");
    }
    return limits;
}

} // namespace raysteps
