#version 410 core
// A ray that a mirror sends on stays inside of what it was in.

uniform usampler2D media;

out uvec4 next_media;

void main() {
    next_media = texelFetch(media, ivec2(gl_FragCoord.xy), 0);
}
