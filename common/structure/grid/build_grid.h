#pragma once

#include "structure/grid/grid.h"

#include <span>

namespace raysteps {

// The number of the cell across a face (grid.h); -1 where the grid ends.
std::int64_t neighbour_across(const GridShape& shape, std::int64_t cell, int face);

// Sets the bits of all references that say which neighbours list the triangle as well. The
// references must be sorted, and hold triangles only. In time linear in their number.
Grid mark_neighbours(Grid grid, unsigned threads);

// The grid of these triangles, three corners each. Two passes over the triangles, one that counts
// and one that fills, in time linear in the number of references; the same grid for any number of
// threads. Throws InputError where the options make no sense, where a corner is not finite, where
// there are more than 2^26 triangles, and where cells and references would take more than
// memory_limit, and MachineError where they are more than most_texels, both before they are taken.
// Where the grid will be slow (slow_grid), it warns after the first pass.
Grid build_grid(std::span<const glm::vec3> corners, const GridOptions& options);

// What is to be said of a grid that makes a ray test more triangles than the loop over all of them;
// nothing where it does not.
//
// A ray along the longest axis of the grid goes through one of its columns, with as many cells as
// the grid has there. Over all columns, it meets references / columns of them: a triangle that is
// long beside the cells is listed, and so tested, in many cells of one column. The loop makes one
// test a triangle. So the grid is slow where there are more references a triangle than columns.
// (That a grid without long triangles has about as many columns as cells ^ (2/3), and a few
// references a triangle, is what makes it fast.) Under 1,000 references on the way nothing is said:
// a picture of 512 x 512 such rays makes 262 million tests, and two cores make 334 million in a
// second (chapter 02: ./run.sh 02 --scene bunny).
std::string slow_grid(const GridShape& shape, std::int64_t references, std::size_t triangles);

// The builder's options as a request has them. Throws InputError where a value makes no sense.
GridOptions grid_options_of(const BuildRequest& request);

// What is to be known of a grid over so many triangles, and of the seconds that building took.
std::vector<Fact> facts_of(const Grid& grid, std::size_t triangles, double seconds);

// What cells and references take, in bytes.
std::int64_t memory_of(const Grid& grid);

} // namespace raysteps
