#include "scene/load_scene.h"

#include "scene/sample_scenes.h"

namespace raysteps {

namespace {

constexpr std::size_t column_width = 22;

std::string line_of(const SampleScene& sample) {
    std::string name(sample.name);
    std::string ranges;
    for (const SampleParameter& parameter : sample.parameters) {
        name += ":" + std::string(parameter.name);
        ranges += "; " + std::string(parameter.name) + " is " + std::to_string(parameter.lowest) +
                  " to " + std::to_string(parameter.highest) + ", else " +
                  std::to_string(parameter.usual);
    }
    name.resize(column_width, ' ');
    return name + std::string(sample.description) + ranges + "\n";
}

} // namespace

std::string list_scenes() {
    std::string lines;
    for (const SampleScene& sample : sample_scenes()) {
        lines += line_of(sample);
    }
    return lines;
}

} // namespace raysteps
