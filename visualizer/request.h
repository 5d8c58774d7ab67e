#pragma once

#include "state.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raysteps::view {

// What a person asks of the visualizer.
struct Request {
    State state;
    std::filesystem::path screenshot;           // a picture to write instead of opening a window
    std::filesystem::path animation;            // a folder for a picture of each step
    std::vector<std::filesystem::path> exports; // .vtp, .vtm, .gltf, .vtkjs or .json
    std::filesystem::path save_to;              // a file for the state
    bool to_parting = false;                    // --step parting
    std::string help;                           // what --help prints, where it was asked for
};

// Reads the command line. Throws InputError where it makes no sense.
Request read_request(int argc, char** argv);

} // namespace raysteps::view
