#pragma once

#include "basics/ray.h"
#include "scene/mesh.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace raysteps {

// The values of a builder's options, by the name of the family and then of the option.
using FamilyValues = std::map<std::string, std::map<std::string, std::string>>;

// What a hard case is made of: a mesh, and rays that are aimed at what makes it hard.
struct HardScene {
    Mesh mesh;
    std::vector<Ray> rays;
    std::size_t least_hits = 0; // the loop finds so many at least, or the rays are badly aimed
    FamilyValues build_values{};
};

// About how many rays a case should have, and the seed of its random numbers.
struct HardRequest {
    int rays = 1000;
    int seed = 1;
};

// How the right answer is known.
enum class Truth {
    all_hit,  // every ray hits something
    all_miss, // no ray hits anything
    exact,    // the triangle that exact arithmetic finds (reference/exact.h)
    the_loop, // what the loop over every triangle finds: the case is one of structures
    answered, // nothing is promised of the answer, but that there is one and the walk ends
};

// Whether the project promises the right answer, for the watertight triangle test and every
// structure. A case that no method can pass is reported with its figure.
enum class Guarantee { promised, reported };

// Which methods a case is about. Every structure is always tried, with the watertight test.
enum class Tries { structures, structures_and_triangle_tests };

// A situation in which usual methods go wrong.
struct HardCase {
    std::string name;   // T1
    std::string title;  // what is hard, in one sentence
    std::string source; // who wrote of it: author, title, year; empty where it is our own
    Truth truth = Truth::the_loop;
    Guarantee guarantee = Guarantee::promised;
    Tries tries = Tries::structures;
    std::string remedy;       // what helps where a method fails
    int most_rays = 10000000; // more would only repeat themselves, or take too long
    HardScene (*make)(const HardRequest& request) = nullptr;
};

} // namespace raysteps
