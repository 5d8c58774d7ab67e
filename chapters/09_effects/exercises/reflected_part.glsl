// The part of the light along the ray's direction that glass reflects; its normal is the origin.
#include "glass_meeting.glsl"
#include "light/fresnel.glsl"

uvec4 checkpoint(Ray ray, int step) {
    Indices indices = indices_of(step);
    return uvec4(bits(reflected_part(cosine_of(ray), indices.before, indices.behind)), 0u, 0u, 0u);
}
