#pragma once

#include "stage.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raysteps::view {

// What the command line asks for.
struct Request {
    State state;
    std::filesystem::path screenshot;           // a picture to write instead of opening a window
    std::filesystem::path animation;            // a folder for a picture of each step
    std::vector<std::filesystem::path> exports; // .vtp, .vtm, .gltf, .vtkjs or .json
    std::filesystem::path save_to;              // a file for the state
    bool to_parting = false;                    // --step parting
    std::string sought;                         // a cell to mark, as find_cell takes it
    bool fly = false;                           // look at the step from close by
    std::string help;                           // what --help prints; empty without it
};

// Reads the command line. Throws InputError where it makes no sense.
Request read_request(int argc, char** argv);

// Writes the pictures and files of the request, or opens a window. The stage shows the request's
// state. Defined in vtk/, or in absent/ where VTK is missing. Throws MachineError where the machine
// cannot draw.
void show_view(const Request& request, Stage& stage);

} // namespace raysteps::view
