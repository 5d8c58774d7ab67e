#pragma once

#include "basics/ray.h"
#include "structure_cells.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// What a ray wants to know: the nearest hit, or whether there is any.
enum class Question { nearest, any };

// What became of a place that a walk came to.
enum class Outcome {
    tested,  // a triangle by itself, where there is no structure
    entered, // an inner node: on to one of its children
    climbed, // an inner node, on the way up
    emptied, // an inner node of several children: none of their boxes is met before the best hit
    missed,  // left out: the ray does not meet the box
    behind,  // left out: the box begins behind the best hit
    touched, // left out: the ray only touches the leaf in a point, on its way to the next
    leaf,    // a cell or a leaf: its triangles are tested
};

// Why a walk came to its end.
enum class Ending {
    no_way_in,   // the ray passes the structure by
    hit,         // no nearer hit can come
    found,       // any hit will do
    ray_is_over, // at t_max
    outside,     // the ray has left the structure
    all_seen,    // no node or triangle is left
    told,        // recorded elsewhere: it ends there, and why is not known
    cut,         // recorded elsewhere, and not to its end
};

// One triangle test, and what it found.
struct TriangleTest {
    int triangle = no_triangle;
    Hit hit;           // no_triangle where it is missed
    bool best = false; // nearer than all before
};

// One step of a walk: a place that it came to, and the tests made there.
struct Step {
    Outcome outcome = Outcome::leaf;
    int place = 0;      // as the walk calls it
    int round = 0;      // in which it began, of a walk that was recorded round by round
    int cell = no_cell; // in StructureCells; no_cell where there is no structure
    float entry = 0.0f; // where the ray is in the box; entry > exit where it is not
    float exit = 0.0f;
    int axis = no_axis;   // of the plane that decides where to go on
    float plane_t = 0.0f; // where the ray meets that plane, of an inner node of a kd-tree
    int face = -1;  // by which the ray leaves: 2 * axis is the lower one, 2 * axis + 1 the upper
    int listed = 0; // triangles in the leaf
    std::size_t first_test = 0; // of the walk's tests, [first, end)
    std::size_t end_test = 0;
    Hit nearest; // after the step
};

// What a ray did in a structure, from beginning to end.
struct RecordedWalk {
    std::string structure; // bvh_ordered
    std::string told_by;   // the name of a walk that was recorded elsewhere; empty of ours
    Ray ray;
    Question question = Question::nearest;
    std::vector<Step> steps;
    std::vector<TriangleTest> tests;
    Ending ending = Ending::no_way_in;
    Hit hit;
};

inline bool is_culled(Outcome outcome) {
    return outcome == Outcome::missed || outcome == Outcome::behind || outcome == Outcome::touched;
}

inline std::span<const TriangleTest> tests_of(const RecordedWalk& walk, const Step& step) {
    return std::span(walk.tests).subspan(step.first_test, step.end_test - step.first_test);
}

} // namespace raysteps
