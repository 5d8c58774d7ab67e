#version 410 core
// The walks of 2 x 2 neighbours, side by side in one fragment. Four that do not come to their end
// leave no mark: pass/trace/resume.frag traces them one by one.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/triangles.glsl"
#include "core/vector.glsl"
#include <triangle>
#include <cutout>
#include "observer/none.glsl"
#include <packet>

uniform sampler2D ray_origins;
uniform sampler2D ray_directions;
uniform float near_enough; // a hit at most this far ends the walk: see core/queries.glsl
uniform int rounds;        // what the platform's loops can bear in one launch

layout(location = 0) out uvec4 lower_left;
layout(location = 1) out uvec4 lower_right;
layout(location = 2) out uvec4 upper_left;
layout(location = 3) out uvec4 upper_right;

void main() {
    ivec2 corner = 2 * ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(ray_origins, 0) - 1; // beyond the edge of an odd picture: once more
    Ray rays[4];
    for (int i = 0; i < 4; ++i) {
        ivec2 pixel = min(corner + ivec2(i & 1, i >> 1), last);
        rays[i] =
            unpack_ray(texelFetch(ray_origins, pixel, 0), texelFetch(ray_directions, pixel, 0));
    }
    PacketWalk walk = walk_packet(rays, near_enough, rounds);
    if (!walk.ended) {
        discard;
    }
    lower_left = pack_hit(walk.nearest[0]);
    lower_right = pack_hit(walk.nearest[1]);
    upper_left = pack_hit(walk.nearest[2]);
    upper_right = pack_hit(walk.nearest[3]);
}
