#include "command/parse_options.h"

#include "error/error.h"

#include <glm/geometric.hpp>

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

namespace raysteps {

namespace {

constexpr int largest_side = 16384;

template <class Number>
std::optional<Number> parse_number(const std::string& text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return number;
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> words(1);
    for (const char letter : text) {
        if (letter == separator) {
            words.emplace_back();
        } else {
            words.back() += letter;
        }
    }
    return words;
}

} // namespace

PictureSize parse_size(const std::string& text) {
    const std::vector<std::string> words = split(text, 'x');
    const auto width = parse_number<int>(words.front());
    const auto height = parse_number<int>(words.back());
    const auto fits = [](int side) { return side >= 1 && side <= largest_side; };
    if (words.size() > 2 || !width || !height || !fits(*width) || !fits(*height)) {
        throw InputError("--size " + text +
                         ": a size is WIDTHxHEIGHT, as in 640x480, each from 1 to " +
                         std::to_string(largest_side) + ".");
    }
    return {*width, *height};
}

Camera parse_camera(const std::string& text, const Camera& start) {
    const std::vector<std::string> words = split(text, ',');
    std::vector<float> numbers;
    for (const std::string& word : words) {
        const auto number = parse_number<float>(word);
        if (number && std::isfinite(*number)) {
            numbers.push_back(*number);
        }
    }
    const bool may_be_camera = words.size() == 6 || words.size() == 7 || words.size() == 10;
    if (numbers.size() != words.size() || !may_be_camera) {
        throw InputError("--camera " + text +
                         ": a camera is six numbers, eye x,y,z and target x,y,z, and perhaps the "
                         "vertical field of view in degrees, as in 0,1,5,0,0,0,40, and then up "
                         "x,y,z.");
    }
    Camera camera = start;
    camera.eye = {numbers[0], numbers[1], numbers[2]};
    camera.target = {numbers[3], numbers[4], numbers[5]};
    if (numbers.size() >= 7) {
        camera.vertical_field_of_view = numbers[6];
    }
    if (numbers.size() == 10) {
        camera.up = {numbers[7], numbers[8], numbers[9]};
    }
    if (camera.vertical_field_of_view <= 0.0f || camera.vertical_field_of_view >= 180.0f) {
        throw InputError("--camera " + text +
                         ": the field of view is over 0 and under 180 degrees. Take another.");
    }
    const glm::dvec3 forward = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    if (glm::length(forward) == 0.0) {
        throw InputError("--camera " + text +
                         ": eye and target are the same point. Move one of them.");
    }
    const glm::dvec3 direction = glm::normalize(forward);
    const glm::dvec3 up(camera.up);
    if (glm::length(glm::cross(direction, up)) > 1e-6 * glm::length(up)) {
        return camera;
    }
    if (numbers.size() == 10) {
        throw InputError("--camera " + text +
                         ": up lies in the direction of view. Take another up.");
    }
    // A camera that looks straight up or down needs another direction to call up.
    camera.up =
        std::abs(direction.y) > 0.5 ? glm::vec3(0.0f, 0.0f, -1.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    return camera;
}

ContextKind parse_context(const std::string& text) {
    if (text == "auto") {
        return ContextKind::automatic;
    }
    if (text == "osmesa") {
        return ContextKind::osmesa;
    }
    if (text == "egl") {
        return ContextKind::egl;
    }
    if (text == "window") {
        return ContextKind::window;
    }
    throw InputError("--context " + text +
                     ": there is no such context. Take one of auto, osmesa, egl, window.");
}

} // namespace raysteps
