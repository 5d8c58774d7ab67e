// Where the hit of a pixel's ray lies. Hits are layers of an array: in one as large as the picture,
// or in four of half its size, since a pass that traces 2 x 2 neighbours at once has an output for
// each (pass/trace/trace_packets.frag). For passes alone: C++ reads them by read_hits
// (common/render/rays.h).

uvec4 hit_texel_at(usampler2DArray hits, ivec2 pixel) {
    int shift = textureSize(hits, 0).z >> 2; // 1 of four layers, else 0
    int layer = shift * ((pixel.x & 1) + 2 * (pixel.y & 1));
    return texelFetch(hits, ivec3(pixel.x >> shift, pixel.y >> shift, layer), 0);
}

Hit hit_at(usampler2DArray hits, ivec2 pixel) {
    return unpack_hit(hit_texel_at(hits, pixel));
}
