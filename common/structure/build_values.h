#pragma once

#include "error/error.h"
#include "structure/structure_family.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace raysteps {

// The options of a family with the values that a request has for them.
struct BuildValues {
    const std::vector<BuildOption>& options;
    const BuildRequest& request;
};

// The option of that name. Throws InputError where there is none.
inline const BuildOption& option_of(const BuildValues& values, const std::string& name) {
    const auto place = std::find_if(values.options.begin(), values.options.end(),
                                    [&](const BuildOption& option) { return option.name == name; });
    if (place == values.options.end()) {
        throw InputError("--" + name + ": the structure has no such option. See --help.");
    }
    return *place;
}

// As it was given, or the initial value.
inline std::string text_of(const BuildValues& values, const std::string& name) {
    const auto given = values.request.values.find(name);
    return given == values.request.values.end() ? option_of(values, name).initial : given->second;
}

// The value as a number. Throws InputError where it is none, or out of range.
template <class Number>
Number number_of(const BuildValues& values, const std::string& name, Number lowest,
                 Number highest) {
    const std::string text = text_of(values, name);
    Number number{};
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    if (result.ec != std::errc{} || result.ptr != end || !(number >= lowest && number <= highest)) {
        char range[64];
        std::snprintf(range, sizeof range, "%.10g to %.10g", static_cast<double>(lowest),
                      static_cast<double>(highest));
        throw InputError("--" + name + " " + text + ": " + option_of(values, name).meaning +
                         ". Give a number from " + range + ".");
    }
    return number;
}

// The value as one of a few words. Throws InputError where it is none of them.
template <class Choice>
Choice choice_of(const BuildValues& values, const std::string& name,
                 const std::vector<std::pair<std::string, Choice>>& choices) {
    const std::string text = text_of(values, name);
    std::string words;
    for (const auto& [word, choice] : choices) {
        if (word == text) {
            return choice;
        }
        words += (words.empty() ? "" : ", ") + word;
    }
    throw InputError("--" + name + " " + text + ": there is no such choice. Take one of " + words +
                     ".");
}

} // namespace raysteps
