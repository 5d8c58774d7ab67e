#pragma once

#include "basics/error.h"
#include "basics/text.h"
#include "structure/structure.h"

#include <sstream>
#include <type_traits>
#include <utility>

namespace raysteps {

// One option of a builder: --NAME sets a member of the builder's struct of options. What --help
// calls the default is the value in the struct itself.
template <class Options>
struct OptionRow {
    std::string name;
    std::string meaning;
    std::function<std::string(const Options& options)> text; // as a person writes the value
    std::function<void(Options& options, const std::string& text)> set; // throws InputError
};

// A number from lowest to highest, which the member holds in units of its own.
template <class Options, class Number>
OptionRow<Options> number_option(const std::string& name, Number Options::*member,
                                 std::type_identity_t<Number> lowest,
                                 std::type_identity_t<Number> highest, const std::string& meaning,
                                 std::type_identity_t<Number> unit = 1) {
    const auto written = [](Number number) {
        std::ostringstream text;
        text << number;
        return text.str();
    };
    const auto set = [=](Options& options, const std::string& text) {
        const std::optional<Number> number = parse_number<Number>(text);
        if (!number || !(*number >= lowest && *number <= highest)) { // NaN is out of range too
            throw InputError("--" + name + " " + text + ": " + meaning + ". Give a number from " +
                             written(lowest) + " to " + written(highest) + ".");
        }
        options.*member = *number * unit;
    };
    return {name, meaning, [=](const Options& options) { return written(options.*member / unit); },
            set};
}

// One of a few words.
template <class Options, class Choice>
OptionRow<Options> choice_option(const std::string& name, Choice Options::*member,
                                 const std::vector<std::pair<std::string, Choice>>& choices,
                                 const std::string& meaning) {
    const auto word_of = [=](const Options& options) {
        for (const auto& [word, choice] : choices) {
            if (choice == options.*member) {
                return word;
            }
        }
        return std::string();
    };
    const auto set = [=](Options& options, const std::string& text) {
        std::vector<std::string_view> words;
        for (const auto& [word, choice] : choices) {
            if (word == text) {
                options.*member = choice;
                return;
            }
            words.push_back(word);
        }
        throw InputError(no_such_choice("--" + name, text, "choice", words));
    };
    return {name, meaning, word_of, set};
}

// What a person is told of the options, and of these defaults.
template <class Options>
std::vector<BuildOption> options_of(const std::vector<OptionRow<Options>>& rows,
                                    const Options& defaults = {}) {
    std::vector<BuildOption> options;
    for (const OptionRow<Options>& row : rows) {
        options.push_back({row.name, row.text(defaults), row.meaning});
    }
    return options;
}

// The options of a request; those that it does not name keep their defaults. Throws InputError.
template <class Options>
Options read_options(const std::vector<OptionRow<Options>>& rows, const BuildRequest& request,
                     const Options& defaults = {}) {
    Options options = defaults;
    for (const OptionRow<Options>& row : rows) {
        const auto given = request.values.find(row.name);
        if (given != request.values.end()) {
            row.set(options, given->second);
        }
    }
    return options;
}

} // namespace raysteps
