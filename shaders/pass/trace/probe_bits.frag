#version 410 core
// Copies integers, to see that the platform does not take them for floats.

uniform usampler2D bits;

out uvec4 copied;

void main() {
    copied = texelFetch(bits, ivec2(gl_FragCoord.xy), 0);
}
