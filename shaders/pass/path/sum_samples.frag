#version 410 core
// Adds the samples of each pixel, one after the other, so that the sum does not depend on how many
// lie side by side.

uniform sampler2D samples;
uniform sampler2D sum_before;
uniform int picture_width;
uniform int picture_height;
uniform int sample_count;
uniform int pictures_across;

out vec4 sum;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    precise vec4 total = texelFetch(sum_before, pixel, 0);
    for (int i = 0; i < sample_count; ++i) {
        ivec2 corner =
            ivec2(i % pictures_across * picture_width, i / pictures_across * picture_height);
        precise vec4 next = total + texelFetch(samples, pixel + corner, 0);
        total = next;
    }
    sum = total;
}
