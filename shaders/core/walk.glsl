// How far a walk through a structure has come. A launch need not finish it: the next one takes it
// up from here.
struct Walk {
    Hit nearest; // of the triangles tested so far
    ivec3 place; // where it goes on; what the numbers mean is the structure's own affair
    bool ended;
};

// How a walk lies in two texels of integers: the hit as core/texels.glsl has it; the place,
// with 1 in w where the walk has ended.

uvec4 pack_place(Walk walk) {
    return uvec4(uint(walk.place.x), uint(walk.place.y), uint(walk.place.z), walk.ended ? 1u : 0u);
}

Walk unpack_walk(uvec4 hit_texel, uvec4 place_texel) {
    Walk walk;
    walk.nearest = unpack_hit(hit_texel);
    walk.place = ivec3(int(place_texel.x), int(place_texel.y), int(place_texel.z));
    walk.ended = place_texel.w != 0u;
    return walk;
}

// The triangle in the hit texel of a walk that has not ended, which is no hit and no miss.
const int unfinished_walk = -2;

bool is_unfinished(uvec4 hit_texel) {
    return int(hit_texel.w) == unfinished_walk;
}

Walk ended_walk(uvec4 hit_texel) {
    Walk walk;
    walk.nearest = unpack_hit(hit_texel);
    walk.place = ivec3(0);
    walk.ended = true;
    return walk;
}
