#include "program_length.h"

#include "gpu/shaders.h"

#include <algorithm>
#include <fstream>

namespace raysteps {

namespace {

std::vector<std::string> files_of(const std::string& structure) {
    return read_shader("pass/trace/trace.frag", {{"real", "real/float.glsl"},
                                           {"triangle", find_part("triangle", "watertight")},
                                           {"structure", find_part("structure", structure)},
                                           {"observer", "observer/none.glsl"}})
        .files;
}

int count_lines(const std::string& file) {
    std::ifstream text(shader_folder() / file);
    int lines = 0;
    std::string line;
    while (std::getline(text, line)) {
        const std::size_t begin = line.find_first_not_of(" \t");
        const bool says_something = begin != std::string::npos && line.compare(begin, 2, "//") != 0;
        lines += says_something ? 1 : 0;
    }
    return lines;
}

} // namespace

ProgramLength program_length(const std::string& structure) {
    const std::vector<std::string> common = files_of("every_triangle");
    ProgramLength length{structure, 0};
    for (const std::string& file : files_of(structure)) {
        if (std::find(common.begin(), common.end(), file) == common.end()) {
            length.lines += count_lines(file);
        }
    }
    return length;
}

} // namespace raysteps
