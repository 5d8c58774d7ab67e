#pragma once

#include <vector>

namespace raysteps {

// Heights at the crossings of a square grid, row by row: (cells + 1) * (cells + 1) numbers.
struct HeightField {
    int cells = 1;
    std::vector<float> heights;
};

float height_at(const HeightField& field, int column, int row);

// A random mountain of 2^depth * 2^depth cells with its corners at 0: midpoints are moved by random
// amounts that halve from level to level (Fournier, Fussell and Carpenter, "Computer rendering of
// stochastic models", 1982). The same seed gives the same bits.
HeightField random_mountain(int depth, int seed);

} // namespace raysteps
