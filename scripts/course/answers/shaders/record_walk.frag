#version 410 core
// The walk of one ray in launches of one round each, as if the platform cut it everywhere. A pixel
// makes it up to the event of its own number, and writes that event with the state of the walk
// after its round.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/walk.glsl"
#include "core/triangles.glsl"
#include "core/vector.glsl"
#include <triangle>
#include "cutout/none.glsl"
#include <observer>
#include <structure>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform int any_will_do; // 1 where the first hit found ends the walk
uniform int side;        // of the picture: its pixels are the events, and no walk has more rounds

layout(location = 0) out uvec4 event;
layout(location = 1) out uvec4 nearest;
layout(location = 2) out uvec4 place;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    wanted_event = pixel.x + side * pixel.y;
    Ray ray =
        unpack_ray(texelFetch(ray_origins, ivec2(0), 0), texelFetch(ray_directions, ivec2(0), 0));
    real near_enough = any_will_do != 0 ? real(farthest) : -real(farthest);
    Walk walk = start_walk(ray);
    while (!walk.ended && seen_events <= wanted_event && present_round < side * side) {
        present_round = present_round + 1;
        walk = go_on(walk, ray, near_enough, 1);
    }
    event = uvec4(observations().xyz, walk.ended ? 1u : 0u);
    nearest = uvec4(floatBitsToUint(float(walk.nearest.t)), floatBitsToUint(float(walk.nearest.u)),
                    floatBitsToUint(float(walk.nearest.v)), uint(walk.nearest.triangle));
    place = uvec4(walk.place, 0);
}
