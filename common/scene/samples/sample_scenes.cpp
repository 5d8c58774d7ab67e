#include "scene/samples/sample_scenes.h"

#include "basics/error.h"
#include "basics/text.h"
#include "scene/frame_scene.h"
#include "scene/samples/samples.h"

#include <limits>
#include <system_error>

namespace raysteps {

namespace {

using Values = std::vector<int>;

constexpr int greatest_seed = std::numeric_limits<int>::max();

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
    const auto value = parse_number<int>(text);
    if (!value || *value < parameter.lowest || *value > parameter.highest) {
        throw InputError(pattern_of(sample) + ": " + std::string(parameter.name) +
                         " is a whole number from " + range_of(parameter) + ", not " +
                         in_quotes(text) + ".");
    }
    return *value;
}

[[noreturn]] void refuse_name(std::string_view name) {
    std::vector<std::string_view> names;
    for (const SampleScene& sample : sample_scenes()) {
        names.push_back(sample.name);
    }
    throw InputError(
        "There is no scene " + in_quotes(name) + "." + did_you_mean(name, names) +
        " Give a model file, such as one that ends in .obj, .ply, .stl or .glb, a .toml file, or a "
        "name that --list-scenes shows.");
}

} // namespace

const std::vector<SampleScene>& sample_scenes() {
    static const std::vector<SampleScene> scenes = {
        {"mirrors",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_mirrors(); },
         "mirror balls and coloured solids on a checkered floor"},
        {"cornell_box",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_cornell_box(); },
         "the measured Cornell box with its two blocks"},
        {"sphereflake",
         {{"DEPTH", 0, 5, 3}},
         SampleView::its_own,
         [](const Values& values) { return sample_sphereflake(values[0]); },
         "a ball with nine smaller balls on it, and so on"},
        {"tetrahedron",
         {{"DEPTH", 0, 10, 6}},
         SampleView::framed,
         [](const Values& values) { return sample_tetrahedron(values[0]); },
         "Sierpinski's tetrahedron"},
        {"mount",
         {{"DEPTH", 0, 10, 6}},
         SampleView::its_own,
         [](const Values& values) { return sample_mount(values[0]); },
         "a fractal mountain under four mirror balls"},
        {"compact",
         {{"SIZE", 1, 400, 32}},
         SampleView::framed,
         [](const Values& values) { return sample_compact(values[0]); },
         "a single ball of equal triangles"},
        {"knot",
         {{"SIZE", 1, 64, 8}},
         SampleView::framed,
         [](const Values& values) { return sample_knot(values[0]); },
         "a dense torus knot"},
        {"soup",
         {{"COUNT", 1, 20'000'000, 10'000}, {"SEED", 0, greatest_seed, 1}},
         SampleView::framed,
         [](const Values& values) { return sample_soup(values[0], values[1]); },
         "random triangles"},
        {"stadium",
         {{"SIZE", 1, 64, 8}},
         SampleView::its_own,
         [](const Values& values) { return sample_stadium(values[0]); },
         "a tiny dense knot in a large empty stadium"},
        {"needles",
         {{"COUNT", 1, 4'000'000, 2'000}, {"SEED", 0, greatest_seed, 1}},
         SampleView::framed,
         [](const Values& values) { return sample_needles(values[0], values[1]); },
         "long thin triangles in all directions"},
        {"bunny",
         {},
         SampleView::framed,
         [](const Values&) { return sample_bunny(); },
         "the Stanford bunny of Debian's package glmark2-data"},
        {"glass_box",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_glass_box(); },
         "a box with a mirror ball and a glass ball under a lamp with an area"},
        {"glass_bunny",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_glass_bunny(); },
         "the Stanford bunny of green glass on a checkered floor"},
        {"pictures",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_pictures(); },
         "a globe, a box, bricks and wood: surfaces with textures"},
        {"soft_light",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_soft_light(); },
         "matte solids under one wide lamp"},
        {"lens",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_lens(); },
         "a row of balls before a camera with a wide lens"},
        {"room",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_room(); },
         "an interior that calls for nearly every effect"},
    };
    return scenes;
}

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
