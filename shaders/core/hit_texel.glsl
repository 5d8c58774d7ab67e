// How a hit lies in one RGBA texel, as the paper wants it: t, u, v and the triangle. The texel
// holds the bits of the numbers as integers, so that the triangle is exact beyond 2^24 and nothing
// is flushed to zero on the way.

uvec4 pack_hit(Hit hit) {
    return uvec4(floatBitsToUint(float(hit.t)), floatBitsToUint(float(hit.u)),
                 floatBitsToUint(float(hit.v)), uint(hit.triangle));
}

Hit unpack_hit(uvec4 texel) {
    Hit hit;
    hit.t = real(uintBitsToFloat(texel.x));
    hit.u = real(uintBitsToFloat(texel.y));
    hit.v = real(uintBitsToFloat(texel.z));
    hit.triangle = int(texel.w);
    return hit;
}
