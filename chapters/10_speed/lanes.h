#pragma once

#include "image/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace raysteps {

// What walks counted, one number for each texel of their rays: the bottom row first.
struct CountedVisits {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> visits;
};

// Mesa's llvmpipe runs the fragments of so many pixels side by side, one in each lane of a vector
// of 256 bits; blocks begin at the first texel. Source: Mesa 22.3, lp_bld_interp.c, quad_offset_x.
inline constexpr int block_columns = 4;
inline constexpr int block_rows = 2;
inline constexpr int lanes_of_block = block_columns * block_rows;

// For each texel, the visits of the slowest ray in its block: so many rounds the block makes, for
// each of its rays.
std::vector<std::uint32_t> rounds_of_blocks(const CountedVisits& counted);

// The part of the lanes that are at work, 0 to 1, over all rounds of all blocks: the visits of all
// rays over those that their blocks make rounds for. A lane beyond the edge, or of an empty ray,
// only waits. 1 where nobody visits anything.
double lanes_at_work(const CountedVisits& counted);

// One walk with what it counted for the rays of a picture.
struct CountedWalk {
    std::string name;
    CountedVisits counted;
};

// Side by side the rounds of the walks' blocks, in the same colours; below them the part of each
// block's lanes that are at work. Throws InputError unless all have the same size.
Image draw_blocks(const std::vector<CountedWalk>& walks);

} // namespace raysteps
