#pragma once

#include <string>
#include <vector>

namespace raysteps {

// An OBJ file that tempts a loader, and what an honest one makes of it.
struct FileCase {
    std::string name;  // F1
    std::string title; // what is wrong, in one sentence
    std::string text;
    int triangles = -1; // of the scene; below 0: the file is refused
    std::string says;   // words of the sentence that it is refused with, or of a message
};

std::vector<FileCase> file_cases();

// An MTL file with values that no material has: Ni = 0, a negative Kd, an infinite Ns, d over 1.
std::string mtl_of_impossible_values();

} // namespace raysteps
