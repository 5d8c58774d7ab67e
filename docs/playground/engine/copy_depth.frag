#version 410 core
// Copies depths to where a page can read them (leave_line.glsl).
uniform sampler2D depths;

out vec4 copied;

void main() {
    copied = vec4(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).x);
}
