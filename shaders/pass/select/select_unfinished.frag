#version 410 core
// Draws the pixels whose walk has not ended, so that a query can count them.

uniform usampler2D places;

void main() {
    if (texelFetch(places, ivec2(gl_FragCoord.xy), 0).w != 0u) {
        discard;
    }
}
