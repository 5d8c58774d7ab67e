#include "scene/height_field.h"

#include "scene/random_numbers.h"

#include <cstddef>
#include <utility>

namespace raysteps {

namespace {

std::size_t index_of(const HeightField& field, int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(field.cells + 1) +
           static_cast<std::size_t>(column);
}

// Every cell as four: the old heights, means at the new crossings, and a random amount on these.
HeightField refine(const HeightField& coarse, RandomNumbers& random, float roughness) {
    HeightField fine;
    fine.cells = 2 * coarse.cells;
    for (int row = 0; row <= fine.cells; ++row) {
        for (int column = 0; column <= fine.cells; ++column) {
            const int left = column / 2;
            const int above = row / 2;
            const int right = left + column % 2;
            const int below = above + row % 2;
            const float mean =
                0.25f * (height_at(coarse, left, above) + height_at(coarse, right, above) +
                         height_at(coarse, left, below) + height_at(coarse, right, below));
            const bool is_new = column % 2 == 1 || row % 2 == 1;
            const float change = is_new ? roughness * (2.0f * random.unit() - 1.0f) : 0.0f;
            fine.heights.push_back(mean + change);
        }
    }
    return fine;
}

} // namespace

float height_at(const HeightField& field, int column, int row) {
    return field.heights[index_of(field, column, row)];
}

HeightField random_mountain(int depth, int seed) {
    RandomNumbers random(seed);
    HeightField field{1, {0.0f, 0.0f, 0.0f, 0.0f}};
    if (depth == 0) {
        return field;
    }
    // The summit stands in the middle.
    field = {2, {0.0f, 0.0f, 0.0f, 0.0f, 0.75f, 0.0f, 0.0f, 0.0f, 0.0f}};
    float roughness = 0.3f;
    for (int level = 1; level < depth; ++level) {
        field = refine(field, random, roughness);
        roughness *= 0.5f;
    }
    return field;
}

} // namespace raysteps
