#pragma once

namespace raysteps {

// What this machine's OpenGL does without saying so, measured when a program starts.
struct Limits {
    int loop_budget;  // rounds after which a shader's loops are stopped silently; see no_loop_limit
    int texture_size; // largest width or height of a texture
};

// The budget of a machine that ran the probe's loop to its end.
inline constexpr int no_loop_limit = 1 << 20;

// GL_MAX_TEXTURE_BUFFER_SIZE. A context must be current.
int most_buffer_texels();

// Runs small passes that show the limits. Throws MachineError where OpenGL computes what no walk
// could work with: a loop that stops within 1,024 rounds, or integers that a texture changes.
Limits measure_limits();

} // namespace raysteps
