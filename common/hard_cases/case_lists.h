#pragma once

#include "hard_cases/hard_case.h"

// The hard cases by their sections, each in its file.
namespace raysteps {

std::vector<HardCase> paper_cases();       // P: what the paper's listing and text get wrong
std::vector<HardCase> triangle_cases();    // T: the triangle test
std::vector<HardCase> grid_cases();        // G: the walk through a grid
std::vector<HardCase> kd_cases();          // K: the walks through a kd-tree
std::vector<HardCase> tree_cases();        // V: trees that are tempted into depth
std::vector<HardCase> determinism_cases(); // D: one answer in any order

// All of one list after those of another.
inline std::vector<Ray> joined(std::vector<Ray> first, const std::vector<Ray>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

// So many of the rays, from 0 to 1.
inline std::size_t part_of(const std::vector<Ray>& rays, double part) {
    return static_cast<std::size_t>(part * static_cast<double>(rays.size()));
}

} // namespace raysteps
