#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace raysteps {

// What a scene's triangles ask of arithmetic.
struct SceneNeeds {
    int triangles = 0;
    double smallest_edge = 0.0;
    double largest_coordinate = 0.0;
    double size = 0.0;           // the longest side of the box
    double thinnest = 0.0;       // the greatest of longest edge / height over it, of all triangles
    int slivers = 0;             // triangles thinner than 1 : 1000
    int without_area = 0;        // triangles
    int small_for_the_paper = 0; // triangles whose edges' product is under the listing's 1e-6
    int open_edges = 0;          // that do not have a partner the other way round
    double digits_left =
        0.0; // of the smallest edge, in bits, beside the ulp of the largest coordinate
};

SceneNeeds find_needs(const Scene& scene);

// What follows, one sentence each, with the numbers that say so.
std::vector<std::string> to_sentences(const SceneNeeds& needs);

} // namespace raysteps
