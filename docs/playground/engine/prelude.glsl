#version 300 es
// What stands in the place of the line `#version 410 core` when a shader of the project is compiled
// by a browser. No character of a part or a pass is changed. Buffer textures lie in rows of 2,048
// texels; `precise` has no like in GLSL ES 3.00 (leave_no_mark.glsl has what takes its place); and
// every loop ends after so many rounds of all loops together.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp isampler2D;
precision highp usampler2D;
precision highp usampler2DArray;
#define precise
#define samplerBuffer sampler2D
#define isamplerBuffer isampler2D
#define usamplerBuffer usampler2D
ivec2 place_in_rows(int i) { return ivec2(i & 2047, i >> 11); }
vec4 texel_of(sampler2D texels, int i) { return texelFetch(texels, place_in_rows(i), 0); }
ivec4 texel_of(isampler2D texels, int i) { return texelFetch(texels, place_in_rows(i), 0); }
uvec4 texel_of(usampler2D texels, int i) { return texelFetch(texels, place_in_rows(i), 0); }
vec4 texel_of(sampler2D image, ivec2 place, int level) { return texelFetch(image, place, level); }
ivec4 texel_of(isampler2D image, ivec2 place, int level) { return texelFetch(image, place, level); }
uvec4 texel_of(usampler2D image, ivec2 place, int level) { return texelFetch(image, place, level); }
uvec4 texel_of(usampler2DArray image, ivec3 place, int level) { return texelFetch(image, place, level); }
#define texelFetch texel_of
const int most_rounds_of_loops = 20000;
int rounds_of_loops = 0;
int line_that_ran_out = 0;
bool is_over(int line) {
    line_that_ran_out = rounds_of_loops == most_rounds_of_loops ? line : line_that_ran_out;
    return rounds_of_loops++ >= most_rounds_of_loops;
}
#define while(condition) while (!is_over(__LINE__) && (condition))
#define for(head) for (head) if (is_over(__LINE__)) break; else
