#include "option_values.h"

#include "basics/text.h"

#include <glm/geometric.hpp>

#include <limits>
#include <vector>

namespace raysteps::view {

namespace {

std::vector<float> numbers_of(const std::string& option, const std::string& text, std::size_t count,
                              const std::string& form) {
    const auto numbers = parse_numbers(text);
    if (!numbers || numbers->size() != count) {
        throw InputError("--" + option + " " + text + ": give " + form + ".");
    }
    return *numbers;
}

} // namespace

int whole_number(const std::string& option, const std::string& text, int lowest) {
    const auto number = parse_number<int>(text);
    if (!number || *number < lowest) {
        throw InputError("--" + option + " " + text + ": give a whole number from " +
                         std::to_string(lowest) + " on.");
    }
    return *number;
}

glm::ivec2 read_pixel(const std::string& text) {
    const std::vector<std::string> words = split_words(text, ',');
    const auto x = parse_number<int>(words.front());
    const auto y = parse_number<int>(words.back());
    if (words.size() != 2 || !x || !y) {
        throw InputError("--pixel " + text +
                         ": give a column and a row, as in 256,200; 0,0 is at the top left.");
    }
    return {*x, *y};
}

Ray read_ray(const std::string& text) {
    const auto numbers = parse_numbers(text);
    const bool has_range = numbers && numbers->size() == 8;
    const std::vector<float> n =
        has_range ? *numbers
                  : numbers_of("ray", text, 6,
                               "six numbers, the origin x,y,z and the direction x,y,z, or eight, "
                               "with t_min and t_max");
    Ray ray{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, 0.0f, std::numeric_limits<float>::max()};
    if (has_range) {
        ray.t_min = n[6];
        ray.t_max = n[7];
    }
    if (ray.direction == glm::vec3(0.0f)) {
        throw InputError("--ray " + text + ": the direction is 0,0,0. Give it a length.");
    }
    return ray;
}

ClipPlane read_clip(const std::string& text) {
    const std::vector<float> n =
        numbers_of("clip", text, 6, "six numbers, a point x,y,z of the plane and its normal x,y,z");
    const glm::vec3 normal(n[3], n[4], n[5]);
    if (normal == glm::vec3(0.0f)) {
        throw InputError("--clip " + text + ": the normal is 0,0,0. Give it a length.");
    }
    return {{n[0], n[1], n[2]}, glm::normalize(normal)};
}

Levels read_levels(const std::string& text) {
    const std::vector<std::string> words = split_words(text, '-');
    if (words.size() > 2) {
        throw InputError("--levels " + text + ": give a level, as in 3, or two, as in 2-5.");
    }
    const Levels levels{whole_number("levels", words.front(), 0),
                        whole_number("levels", words.back(), 0)};
    if (levels.highest < levels.lowest) {
        throw InputError("--levels " + text + ": the first level is the lower one. Swap them.");
    }
    return levels;
}

} // namespace raysteps::view
