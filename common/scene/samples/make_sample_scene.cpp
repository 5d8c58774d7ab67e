#include "scene/sample_scenes.h"

#include "error/error.h"
#include "scene/frame_scene.h"
#include "scene/nearest_word.h"
#include "scene/obj_findings.h"

#include <charconv>
#include <system_error>

namespace raysteps {

namespace {

// The parts between the colons; one more than there are colons.
std::vector<std::string_view> split_at_colons(std::string_view text) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t colon = text.find(':');
        parts.push_back(text.substr(0, colon));
        if (colon == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(colon + 1);
    }
}

const SampleScene* find_sample(std::string_view name) {
    for (const SampleScene& sample : sample_scenes()) {
        if (sample.name == name) {
            return &sample;
        }
    }
    return nullptr;
}

std::string pattern_of(const SampleScene& sample) {
    std::string pattern(sample.name);
    for (const SampleParameter& parameter : sample.parameters) {
        pattern += ":" + std::string(parameter.name);
    }
    return pattern;
}

std::string range_of(const SampleParameter& parameter) {
    return std::to_string(parameter.lowest) + " to " + std::to_string(parameter.highest);
}

int read_parameter(const SampleScene& sample, const SampleParameter& parameter,
                   std::string_view text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), end, value);
    const bool is_number = result.ec == std::errc() && result.ptr == end;
    if (!is_number || value < parameter.lowest || value > parameter.highest) {
        throw InputError(pattern_of(sample) + ": " + std::string(parameter.name) +
                         " is a whole number from " + range_of(parameter) + ", not " +
                         in_quotes(text) + ".");
    }
    return value;
}

[[noreturn]] void refuse_name(std::string_view name) {
    std::vector<std::string_view> names;
    for (const SampleScene& sample : sample_scenes()) {
        names.push_back(sample.name);
    }
    const std::string nearest(nearest_word(name, names));
    const std::string hint = nearest.empty() ? "" : "Did you mean " + nearest + "? ";
    throw InputError("There is no scene " + in_quotes(name) + ". " + hint +
                     "Give a file that ends in .obj or .toml, or a name that --list-scenes shows.");
}

} // namespace

bool is_sample_name(std::string_view name) {
    return find_sample(name.substr(0, name.find(':'))) != nullptr;
}

Scene make_sample_scene(std::string_view name, float aspect_ratio) {
    const std::vector<std::string_view> parts = split_at_colons(name);
    const SampleScene* sample = find_sample(parts[0]);
    if (sample == nullptr) {
        refuse_name(parts[0]);
    }
    const std::size_t given = parts.size() - 1;
    if (given > sample->parameters.size()) {
        throw InputError(in_quotes(name) + " has " + std::to_string(given) +
                         " parameters, but the scene takes " +
                         std::to_string(sample->parameters.size()) + ". Write " +
                         pattern_of(*sample) + ".");
    }
    std::vector<int> values;
    std::string whole_name(sample->name);
    for (std::size_t i = 0; i < sample->parameters.size(); ++i) {
        const SampleParameter& parameter = sample->parameters[i];
        values.push_back(i < given ? read_parameter(*sample, parameter, parts[i + 1])
                                   : parameter.usual);
        whole_name += ":" + std::to_string(values.back());
    }

    Scene scene = sample->make(values);
    scene.name = whole_name;
    if (sample->view == SampleView::framed) {
        return frame_scene(std::move(scene), aspect_ratio);
    }
    scene.camera = keep_square_in_view(scene.camera, aspect_ratio);
    return scene;
}

} // namespace raysteps
