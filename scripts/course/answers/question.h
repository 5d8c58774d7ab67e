#pragma once

#include "basics/ray.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raysteps {

// Who answers a question.
enum class QuestionKind {
    checkpoint, // a shader part in the slot <checkpoint> of checkpoint.frag, for each ray and step
    walk,       // the walk of one ray, launched round by round
    rays,       // the pass that makes the rays of a picture
    picture,    // all passes of a picture
    difference, // two pictures that were made before
    builder,    // a builder of a structure, in C++
    function,   // a function of a few numbers, in C++
};

// What `./course` wants to know of the shader parts and builders as they stand. Numbers that are
// not named have these values.
struct CourseQuestion {
    QuestionKind kind = QuestionKind::checkpoint;
    std::string subject; // the checkpoint's file, `nearest` or `any` of a walk, `direct` or
                         // `interpolated`, the view of the picture (`whitted`: with light), or
                         // the name of the builder or the function
    std::string scene = "tetrahedron";
    std::string triangle = "watertight";
    std::string structure = "every_triangle";
    // The part that watches the walk of a checkpoint.
    std::string observer = "observer_in_order.glsl";
    std::map<std::string, std::string> options;   // of the builder, as --NAME
    std::vector<Ray> rays;                        // these, and
    int random_rays = 0;                          // so many at the scene's box, from around it
    int seed = 1;                                 // of those
    std::vector<std::string> families{"bounded"}; // of those, in turn: see random_rays.cpp
    int steps = 1;
    int width = 64;
    int height = 48;
    std::map<std::string, int> numbers;       // uniforms, instead of the structure's
    std::map<std::string, glm::vec3> points;  // as well
    std::map<std::string, glm::ivec3> counts; // as well
    std::map<std::string, int> zeros;         // buffers of so many texels of zeros, too
    std::filesystem::path packed;             // where the scene goes, for the playground
    std::filesystem::path picture;            // where the picture goes, or lies, without its ending
    std::filesystem::path reference; // the picture that it is held against, without its ending
};

// A job: {"questions": [{"kind": "checkpoint", "subject": ...}, ...]}, with the names of the fields
// above. A ray is eight integers, the bits of its numbers.
struct Job {
    std::string shaders; // the folders that RAYSTEPS_SHADERS shall name; empty where none are given
    std::vector<CourseQuestion> questions;
};

// Throws InputError with the place, such as a file's name, where the text is no job.
Job parse_job(const std::string& text, const std::string& place);

} // namespace raysteps
