#pragma once

#include "basics/error.h"
#include "cell_choice.h"
#include "state_words.h"

#include <string>

namespace raysteps::view {

// What the value of an option means. All throw InputError, with the option's name and what to give
// instead, where it means nothing.

// The words of choices, between commas.
template <class Choice>
std::string list_of(const Words<Choice>& words) {
    std::string text;
    for (const auto& [word, choice] : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

template <class Choice>
Choice choose(const std::string& option, const std::string& text, const Words<Choice>& words) {
    for (const auto& [word, choice] : words) {
        if (word == text) {
            return choice;
        }
    }
    throw InputError("--" + option + " " + text + ": there is no such choice. Take one of " +
                     list_of(words) + ".");
}

// A whole number, from the lowest on.
int whole_number(const std::string& option, const std::string& text, int lowest);

// Of --pixel: a column and a row, as in 256,200.
glm::ivec2 read_pixel(const std::string& text);

// Of --ray: origin, direction, and perhaps t_min and t_max.
Ray read_ray(const std::string& text);

// Of --clip: a point of the plane and its normal, which gets the length 1.
ClipPlane read_clip(const std::string& text);

// Of --levels: one, as in 3, or two, as in 2-5.
Levels read_levels(const std::string& text);

} // namespace raysteps::view
