#include "trace/live_trace.h"

#include "program/jobs.h"
#include "render/trace_rays.h"
#include "scene/camera_text.h"
#include "structure/structure.h"

#include <algorithm>
#include <utility>

namespace raysteps {

namespace {

using Make = std::function<void()>;

// Changes the value, and back where nothing can be made with it.
template <class Value>
void change(Value& value, Value next, const Make& make) {
    const Value before = std::exchange(value, std::move(next));
    try {
        make();
    } catch (...) {
        value = before;
        throw;
    }
}

LiveChoice word_choice(const std::string& name, char key, std::vector<std::string> words,
                       std::string& value, const Make& make) {
    const auto place = std::find(words.begin(), words.end(), value);
    const auto chosen = static_cast<std::size_t>(place - words.begin());
    return {.name = name,
            .key = key,
            .words = std::move(words),
            .chosen = chosen,
            .take = [&value, make](const std::string& word) { change(value, word, make); }};
}

// The visualizer shows walks of rays by themselves.
std::string view_command(const PictureOptions& picture, const Scene& scene,
                         const TraceOptions& tracing, const SeenPixel& pixel) {
    std::string command =
        "./run.sh view " + shell_word(picture.scene) + " --structure " +
        single_walk(tracing.structure) + " " + camera_text(pixel.camera, scene.camera.up) +
        " --size " + std::to_string(pixel.width) + "x" + std::to_string(pixel.height) +
        " --pixel " + std::to_string(pixel.column) + "," + std::to_string(pixel.row);
    if (picture.scale_exponent != 0) {
        command += " --scale-exponent " + std::to_string(picture.scale_exponent);
    }
    for (const auto& [name, value] : tracing.build_values) {
        command += " --" + name + " " + shell_word(value);
    }
    return command;
}

} // namespace

LiveOffer live_trace(const PictureOptions& picture, const Scene& scene, TraceOptions& tracing,
                     const Make& make) {
    LiveOffer offer;
    offer.choices.push_back(word_choice("walk", 'w', structure_names(), tracing.structure, make));
    offer.choices.push_back(
        word_choice("triangle test", 't', part_names("triangle"), tracing.triangle, make));
    offer.read_shaders = make;
    offer.view_command = [&](const SeenPixel& pixel) {
        return view_command(picture, scene, tracing, pixel);
    };
    return offer;
}

LiveOffer live_trace(const PictureOptions& picture, const Scene& scene, TraceOptions& tracing,
                     std::string& view, const Make& make) {
    const Make checked = [&tracing, &view, make] {
        refuse_empty_heat_map(view, tracing);
        make();
    };
    LiveOffer offer = live_trace(picture, scene, tracing, checked);
    offer.choices.push_back(word_choice("view", 'v', view_names(), view, checked));
    return offer;
}

LiveChoice number_choice(const std::string& name, char key, std::vector<int> numbers, int& value,
                         const Make& make) {
    numbers.push_back(value);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    LiveChoice choice{.name = name, .key = key};
    for (const int number : numbers) {
        choice.chosen = number == value ? choice.words.size() : choice.chosen;
        choice.words.push_back(std::to_string(number));
    }
    choice.take = [&value, make](const std::string& word) { change(value, std::stoi(word), make); };
    return choice;
}

} // namespace raysteps
