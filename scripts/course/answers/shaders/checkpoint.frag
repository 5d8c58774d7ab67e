#version 410 core
// One checkpoint of an exercise, for one ray a pixel: what it finds is four numbers, as bits.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/walk.glsl"
#include "core/view.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/leave_surface.glsl"
#include <triangle>
#include "cutout/none.glsl"
#include <observer>
#include <structure>
#include "core/queries.glsl"
#include "light/surface.glsl"
#include "light/lambert.glsl"
#include "light/shadow.glsl"
#include "light/mirror.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform int step_number; // of checkpoints that look at a walk step by step; counted from 1

uint bits(real value) {
    return floatBitsToUint(float(value));
}

uvec4 bits_of_point(real3 point, int number) {
    return uvec4(bits(point.x), bits(point.y), bits(point.z), uint(number));
}

// Of a miss, t, u and v mean nothing.
uvec4 bits_of_hit(Hit hit) {
    if (!is_hit(hit)) {
        return uvec4(0u, 0u, 0u, uint(no_triangle));
    }
    return uvec4(bits(hit.t), bits(hit.u), bits(hit.v), uint(hit.triangle));
}

// The walk after so many rounds; a launch of each round by itself, as if the platform cut it.
Walk walk_after(Ray ray, int rounds) {
    Walk walk = start_walk(ray);
    for (int round = 0; round < rounds && !walk.ended; ++round) {
        walk = go_on(walk, ray, -real(farthest), 1);
    }
    return walk;
}

#include <checkpoint>

out uvec4 answer;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    answer = checkpoint(ray, step_number);
}
