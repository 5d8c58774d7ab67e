#version 410 core
// One checkpoint of an exercise, for one ray a pixel: what it finds is numbers, as bits. Four are
// what checkpoint() returns, four more it may put in `also`, and the others say what was observed.
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
#include "probes.glsl"

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform int step_number; // of checkpoints that look at a walk step by step; counted from 1

uniform int launch_rounds = 1; // of each launch of a walk, as if the platform cut it there

uvec4 also = uvec4(0u);

// Of a miss, t, u and v mean nothing.
uvec4 bits_of_hit(Hit hit) {
    if (!is_hit(hit)) {
        return uvec4(0u, 0u, 0u, uint(no_triangle));
    }
    return uvec4(bits(hit.t), bits(hit.u), bits(hit.v), uint(hit.triangle));
}

// The walk after so many launches.
Walk walk_after(Ray ray, int launches) {
    Walk walk = start_walk(ray);
    for (int launch = 0; launch < launches && !walk.ended; ++launch) {
        walk = go_on(walk, ray, -real(farthest), launch_rounds);
    }
    return walk;
}

#include <checkpoint>

layout(location = 0) precise out uvec4 answer;
layout(location = 1) precise out uvec4 more;
layout(location = 2) precise out uvec4 observed;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ray ray = unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    answer = checkpoint(ray, step_number);
    more = also;
    observed = observations();
}
