#version 410 core
// How many rounds a loop really makes: some platforms stop a long one, and say nothing.

uniform int rounds;

out uvec4 made;

void main() {
    int i = 0;
    float busy = 1.0;
    for (; i < rounds; ++i) {
        busy = busy * 0.5 + 1.0;
    }
    // The sum is used, so that no compiler may leave out the loop.
    made = uvec4(uint(i), busy > 4.0 ? 1u : 0u, 0u, 0u);
}
